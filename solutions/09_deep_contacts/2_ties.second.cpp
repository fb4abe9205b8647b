#include "exercises/09_deep_contacts/2_ties.hpp"

namespace enduring {

// The sign of a polynomial in eps is that of its first coefficient that is not zero.
int side_of_line(const LatticePoint& p, const LatticePoint& a, const LatticePoint& b, int shift)
{
    const std::int64_t x = b.x - a.x, y = b.y - a.y;
    const std::int64_t of_eps[] = {x * (p.y - a.y) - y * (p.x - a.x), -shift * y, shift * x};
    for (const std::int64_t coefficient : of_eps)
        if (coefficient != 0)
            return coefficient > 0 ? 1 : -1;
    return 0;
}

int crosses(const LatticePoint& p, const LatticePoint& q, const LatticePoint& a, const LatticePoint& b,
            int shift)
{
    const int from = side_of_line(p, a, b, shift), to = side_of_line(q, a, b, shift);
    const int one = side_of_line(a, p, q, -shift), other = side_of_line(b, p, q, -shift);
    return from * to < 0 && one * other < 0 ? from : 0;
}

// A ray to the right: it crosses edges whose ends lie below and above it. The shift lifts the ray, so a
// corner at its height lies below if the shift goes up.
int winding_number(const LatticePoint& point, const LatticePolygon& polygon, int shift)
{
    const auto is_above = [&](const LatticePoint& corner) {
        return corner.y != point.y ? corner.y > point.y : shift < 0;
    };
    int winding = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const LatticePoint &a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        if (is_above(a) == is_above(b))
            continue;
        const int side = side_of_line(point, a, b, shift);
        if (is_above(b) && side > 0)
            ++winding;
        if (is_above(a) && side < 0)
            --winding;
    }
    return winding;
}

}  // namespace enduring
