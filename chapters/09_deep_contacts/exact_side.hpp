#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// A difference of two points that is not rounded: it stays the two.
struct Difference {
    const Vec3 &to, &from;
};

/// Sign of (x + shift e) . (v x w) with e = (eps, eps^2, eps^3) and an eps above 0 and below every number:
/// the sign of x . (v x w) where that is not zero, else that of the first coordinate of v x w that is not
/// zero.
///
/// Never wrong: what the doubles leave open is computed with whole numbers. Coordinates lie between 1e-40 and
/// 1e40 in size, or are zero.
/// @param shift  1, -1, or 0 for no shift at all
/// @return       1 or -1; 0 only for v and w exactly parallel, or for x in their plane without a shift
/// @see Edelsbrunner and Mücke 1990, for the perturbation; Shewchuk 1997, for the bound of the doubles
int side_of_plane(const Difference& x, const Difference& v, const Difference& w, int shift);

}  // namespace enduring
