#pragma once

#include <cstdint>
#include <vector>

namespace enduring {

/// A point of the plane with whole coordinates, at most 1e9 in size.
struct LatticePoint {
    std::int64_t x, y;
};

/// A closed polygon: its corners in order, to the left of its edges is its inside. The last corner is joined
/// to the first.
using LatticePolygon = std::vector<LatticePoint>;

/// On which side of the line from a to b the point p lies, after p was shifted by e = (eps, eps^2) times
/// `shift`. Here eps is larger than zero and smaller than every number.
/// @param shift  1 or -1
/// @return       1 to the left, -1 to the right; 0 only if a and b are the same
int side_of_line(const LatticePoint& p, const LatticePoint& a, const LatticePoint& b, int shift);

/// Whether the segment from p to q, shifted by e times `shift`, crosses the one from a to b.
/// @return  1 from the left side of ab to the right, -1 from the right to the left, 0 not at all
int crosses(const LatticePoint& p, const LatticePoint& q, const LatticePoint& a, const LatticePoint& b,
            int shift);

/// How often a polygon winds around a point that was shifted by e times `shift`: 1 inside, 0 outside of one
/// that runs around its inside once.
int winding_number(const LatticePoint& point, const LatticePolygon& polygon, int shift);

}  // namespace enduring
