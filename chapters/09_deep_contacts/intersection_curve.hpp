#pragma once

#include "chapters/09_deep_contacts/piercing.hpp"

#include <vector>

namespace enduring {

/// A curve in which two surfaces cross: from piercing to piercing, and between two of them along one face of
/// A and one of B. Between closed surfaces every curve is closed; on an open one it may end at the border.
struct IntersectionCurve {
    std::vector<int> piercings;  ///< indices into Intersection::piercings, in their order along the curve
    bool closed = false;
};

/// All curves in which two surfaces cross.
struct Intersection {
    std::vector<Piercing> piercings;
    std::vector<IntersectionCurve> curves;  ///< each piercing is on one of them
};

/// Joins piercings to curves. Two faces that cross have two piercings in common, the ends of a piece of
/// curve.
/// @param piercings  as find_piercings finds them; with others, curves may end anywhere
Intersection join_piercings(std::vector<Piercing> piercings, const StillSurface& a, const StillSurface& b);

/// Traces the curves in which two surfaces cross. Always the same for the same surfaces: the curves in the
/// order of their first piercings.
/// @see Baraff, Witkin and Kass 2003, "Untangling cloth"
Intersection trace_intersection(const StillSurface& a, const StillSurface& b);

}  // namespace enduring
