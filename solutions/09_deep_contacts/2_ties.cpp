#include "exercises/09_deep_contacts/2_ties.hpp"

#include <algorithm>

namespace enduring {
namespace {

int sign(std::int64_t number) { return (number > 0) - (number < 0); }

}  // namespace

int side_of_line(const LatticePoint& p, const LatticePoint& a, const LatticePoint& b, int shift)
{
    const std::int64_t x = b.x - a.x, y = b.y - a.y;
    const std::int64_t area = x * (p.y - a.y) - y * (p.x - a.x);
    if (area != 0)
        return sign(area);
    return shift * (y != 0 ? -sign(y) : sign(x));
}

int crosses(const LatticePoint& p, const LatticePoint& q, const LatticePoint& a, const LatticePoint& b,
            int shift)
{
    const int side = side_of_line(p, a, b, shift);
    if (side == side_of_line(q, a, b, shift))
        return 0;
    const bool apart = side_of_line(a, p, q, -shift) != side_of_line(b, p, q, -shift);
    return apart ? side : 0;
}

int winding_number(const LatticePoint& point, const LatticePolygon& polygon, int shift)
{
    std::int64_t top = point.y;
    for (const LatticePoint& corner : polygon)
        top = std::max(top, corner.y);
    const LatticePoint above{point.x, top + 1};
    int winding = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        winding += crosses(point, above, polygon[i], polygon[(i + 1) % polygon.size()], shift);
    return winding;
}

}  // namespace enduring
