#pragma once

namespace enduring {

//! [distance_parts]
/// Every number of contact by distance. Each says why it is so large, and what a tenth of it does, and ten
/// times as much.
struct DistanceParts {
    /// of the size of a body [1]: its skin, the distance that its springs may be pressed before surfaces
    /// meet. A tenth: steps are halved to hold fast bodies apart; ten times: soft bodies hover visibly.
    double skin = 5e-4;
    /// of the largest singular value of the planes at a vertex [1]: directions in which they say less do not
    /// move it. A tenth: tips of needles recede by a hundred skins; ten times: edges of boxes do not recede
    /// at all.
    double least_recess = 0.1;
    /// of a face's normal [1]: what has to be left of it when its surface moves in. Any number between 0.1
    /// and 0.5 will do.
    double not_turned = 0.25;
    /// sine of the angle of two edges from which their nearest points tell a normal. Ten times: leaning
    /// sticks pass.
    double edge_sine = 1e-3;
    /// sine of the angle by which two faces fold, from which an edge or a vertex between them has directions
    /// of its own: what is flat is flat. Ten times: round bodies with fine meshes lose their edges.
    double least_fold = 1e-4;
    /// of the size of the smaller body [1]: nearer, rounding has left no direction in the difference of two
    /// points. Of the step [1]: crossings no farther apart are at the same moment.
    double touching = 1e-9;
    /// of the size of the smaller body [1]: pairs that push along one line no farther apart are one. A tenth:
    /// corners that lie exactly on each other have pairs that come and go; ten times: small features lose
    /// theirs.
    double same_place = 1e-5;
    /// sine by which a neighbour may pass the plane of a pair. None: squeezed bodies are thrown out; ten
    /// times: everything has a pair.
    double cone_sine = 0.2;
    /// times as stiff as chapter 7's pairs, so that an impact is held within the skins. A tenth: twice as
    /// many halvings.
    double stiffer = 10;
    /// of the step [1]: crossings of two rigid bodies that push the same way and are one impact. A tenth:
    /// facets get their pairs one by one; ten times: planes ahead brake what slides along facets.
    double together = 0.02;
    /// cosine of the angle up to which a vertex hands what it remembers on to another face, and slides from
    /// one face to another, and up to which two crossings push the same way.
    double hand_on = 0.7;
    /// of a skin [1]: what is left of it, at least, where soft bodies or sheets begin nearer to each other. A
    /// tenth: what begins in touch is halved until it stands still; ten times: it is pushed apart.
    double least_skin = 0.1;
    /// in one step: afterwards it is halved, or what still would cross stands still. Five: soft impacts are
    /// halved twice as often.
    int most_answers = 8;
};
inline constexpr DistanceParts distance_parts;
//! [distance_parts]

}  // namespace enduring
