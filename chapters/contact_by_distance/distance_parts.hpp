#pragma once

namespace enduring {

//! [distance_parts]
/// Every number of contact by distance. Each says why it is so large, and what a tenth of it does, and ten times as much.
struct DistanceParts {
    /// of the size of a body [1]: its skin, the distance that its springs may be pressed before surfaces meet. A tenth: steps are halved to
    /// hold fast bodies apart; ten times: soft bodies hover visibly.
    double skin = 5e-4;
    /// of 3 V / A, half of a plate's thickness [1]: the thickest skin. A tenth: thin plates are halved; ten times: they vanish.
    double of_thickness = 0.05;
    /// of the largest singular value of the planes at a vertex [1]: directions in which they say less do not move it. A tenth: tips
    /// of needles recede by a hundred skins; ten times: edges of boxes do not recede at all.
    double least_recess = 0.1;
    /// of a face's normal [1]: what has to be left of it when its surface moves in. Any number between 0.1 and 0.5 will do.
    double not_turned = 0.25;
    /// sine of the angle of two edges from which their nearest points tell a normal. Ten times: leaning sticks pass.
    double edge_sine = 1e-3;
    /// sine of the angle by which two faces fold, from which an edge or a vertex between them has directions of its own: what is
    /// flat is flat. Ten times: round bodies with fine meshes lose their edges.
    double least_fold = 1e-4;
    /// of the size of the smaller body [1]: nearer, rounding has left no direction in the difference of two points.
    double touching = 1e-9;
    /// sine by which a neighbour may pass the plane of a pair. None: squeezed bodies are thrown out; ten times: everything has a pair.
    double cone_sine = 0.2;
    /// times as stiff as chapter 7's pairs, so that an impact is held within the skins. A tenth: twice as many halvings.
    double stiffer = 10;
    /// of the step [1]: crossings of two rigid bodies that are one impact. A tenth: facets get their pairs one by one; ten
    /// times: planes ahead brake what slides along facets.
    double together = 0.02;
    /// of the skins [1]: how far apart a pair is to be at both ends of a step in which its straight paths cross in between.
    double ends_well = 0.1;
    /// halvings after which what a driven body presses through something is left to chapter 9. One: grips slip; ten: jams take
    /// ten times as long.
    int squeezed_after = 5;
    /// in one step: afterwards what still would cross waits for the next, or stands still. The step itself asks five times.
    int most_answers = 5;
};
inline constexpr DistanceParts distance_parts;
//! [distance_parts]

}  // namespace enduring
