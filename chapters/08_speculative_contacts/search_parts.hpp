#pragma once

#include <algorithm>
#include <cmath>

namespace enduring {

//! [search_parts]
/// Every number that decides which features get a pair. Each says why it is so large, and what a tenth of it does, and
/// ten times as much.
struct SearchParts {
    /// of g dt^2, what a body at rest would fall in a step [1]: from how far a pair is made.
    double fall = 1.5;
    /// of the size of the smallest body [1]: the same where gravity is weak or the step is short.
    double nearness = 1e-4;
    /// of the smaller body's size [1]: how deep a pair may be at the start of a step. Deeper, geometry does not tell
    /// on which side a feature came in.
    double inside = 0.1;
    /// of the way that two edges move against each other in a step [1]: how much deeper they may be at its start. Surfaces bend, so what slides
    /// round a corner comes behind the next edge. A tenth: a slippery knot is
    /// pulled through itself. Ten times: its strands cross four times as deep.
    double slid = 0.01;
    /// of the depth of a body's deepest pair [1]: how deep its other features may be that have no pair yet, since it turns. Once as
    /// much loses corners to rounding; ten times takes for inside what lies behind a face beyond an edge.
    double deeper = 2;
    /// sine by which a neighbour may pass the plane of a pair: a body that comes down on a side has all of its corners
    /// in play before it lies flat.
    double cone_sine = 0.2;
    /// sine of the angle from which an edge counts as convex, and two faces as two walls of a vertex.
    double least_fold = 1e-4;
    /// sine of the angle of two edges from which their cross product tells a normal.
    double edge_sine = 1e-4;
    /// of an edge: by how much a pair that is remembered may pass its end, or its rim.
    double hysteresis = 1e-3;
    /// times as stiff as chapter 7's pairs: an impact of the speed v ends about v dt / (100 stiffer) deep, and bodies of 5 cm that
    /// fall for half a second are to stay below half a percent of their size with steps of 20 ms. A tenth: two in five mixed heaps
    /// come deeper, one by 1.7 %. Ten times: a tenth more steps of Newton's method.
    double stiffer = 10;
    /// cosine of the angle up to which a vertex hands what it remembers on to another face, and slides from one face to another.
    double hand_on = 0.7;
    /// of the margin [1]: how deep a vertex may end that comes along a face which turns. Its path is then at right angles to
    /// the normal of the middle of the step, as energy asks; a tenth loses energy in a screw, ten times as much lets corners
    /// of bodies that spin into each other.
    double turned = 0.1;
    /// of the margin [1]: how far a solve may move a vertex across gravity before pairs are searched again. It may come in front of a
    /// feature that was beside it. Ten times: the tips of leaning cards pass each other by half the margin; a tenth: what slides
    /// is searched twice in most steps.
    double aside = 0.1;
};
inline constexpr SearchParts search_parts;
//! [search_parts]

/// How near two bodies' features have to be, in metres.
struct Reach {
    double margin = 0;       ///< apart
    double inside = 0;       ///< inside each other at the start of the step
    bool faces_tell = true;  ///< the outer side of A; not where elements are inside out

    /// How far a feature goes on beyond a border at which no other one takes over [m].
    /// @param depth  of the pair, of either sign [m]
    /// @param path   of the features against each other in the step [m]
    double beyond_border(double depth, double path) const
    {
        return 2 * std::min(inside, std::abs(depth)) + 0.1 * margin + path;
    }
};

}  // namespace enduring
