#include "chapters/09_deep_contacts/piercing.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace enduring {
namespace {

using Exact = boost::multiprecision::cpp_rational;
using ExactVec3 = std::array<Exact, 3>;

int sign(const Exact& number) { return number.sign(); }

ExactVec3 exact(const Difference& d)
{
    return {Exact(d.to.x()) - Exact(d.from.x()), Exact(d.to.y()) - Exact(d.from.y()),
            Exact(d.to.z()) - Exact(d.from.z())};
}

//! [by_whole_numbers]
int side_by_exact_numbers(const Difference& x, const Difference& v, const Difference& w, int shift)
{
    const ExactVec3 a = exact(x), b = exact(v), c = exact(w);
    const ExactVec3 cross{b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
    if (const int side = sign(a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]))
        return side;
    for (const Exact& coordinate : cross)
        if (const int side = sign(coordinate))
            return shift * side;
    return 0;
}
//! [by_whole_numbers]

}  // namespace

//! [side_of_plane]
int side_of_plane(const Difference& x, const Difference& v, const Difference& w, int shift)
{
    const Vec3 a = x.to - x.from, b = v.to - v.from, c = w.to - w.from;
    const double product = a.dot(b.cross(c));
    const Vec3 size = a.cwiseAbs(), sb = b.cwiseAbs(), sc = c.cwiseAbs();
    const double magnitude = size.x() * (sb.y() * sc.z() + sb.z() * sc.y()) +
                             size.y() * (sb.z() * sc.x() + sb.x() * sc.z()) +
                             size.z() * (sb.x() * sc.y() + sb.y() * sc.x());
    constexpr double roundings = 16;  // no term meets more than eight; twice as many are granted
    if (std::abs(product) > roundings * std::numeric_limits<double>::epsilon() / 2 * magnitude)
        return product > 0 ? 1 : -1;
    return side_by_exact_numbers(x, v, w, shift);
}
//! [side_of_plane]

}  // namespace enduring
