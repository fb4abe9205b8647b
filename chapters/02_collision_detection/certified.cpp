#include "chapters/02_collision_detection/certified.hpp"

#include "chapters/02_collision_detection/first_touch.hpp"

#include <stdexcept>
#include <string>
#include <type_traits>

namespace enduring {
namespace {

using namespace certified;

/// Coordinate differences of this size neither overflow nor underflow in a product of four.
constexpr double smallest_size = 0x1p-200, largest_size = 0x1p200;

/// Do two vectors certainly point to opposite sides along some axis, throughout?
bool disagree(const MovingVector<double, 2>& m, const MovingVector<double, 2>& n)
{
    const auto opposite = [&](double Triple<double>::* axis) {
        const double m_error = m.error, n_error = n.error;
        const double m_low = std::min({m.c[0].*axis, m.c[1].*axis, m.c[2].*axis});
        const double n_low = std::min({n.c[0].*axis, n.c[1].*axis, n.c[2].*axis});
        const double m_high = std::max({m.c[0].*axis, m.c[1].*axis, m.c[2].*axis});
        const double n_high = std::max({n.c[0].*axis, n.c[1].*axis, n.c[2].*axis});
        return (m_low > m_error && n_high < -n_error) || (m_high < -m_error && n_low > n_error);
    };
    return opposite(&Triple<double>::x) || opposite(&Triple<double>::y) || opposite(&Triple<double>::z);
}

//! [glance]
/// The height, then the sides, each dropped as soon as it has answered: most pairs end here.
bool apart_at_first_glance(const VertexFaceDifferences<double>& d)
{
    const auto side_0 = cross(d.d1, d.d2);
    if (dot(d.d0, side_0).sign() != 0)
        return true;
    const auto side_1 = cross(d.d2, d.d0);
    if (disagree(side_0, side_1))
        return true;
    const auto side_2 = cross(d.d0, d.d1);
    return disagree(side_1, side_2) || disagree(side_2, side_0);
}
//! [glance]

bool apart_at_first_glance(const EdgeEdgeDifferences<double>& d)
{
    const auto side_0 = cross(d.b, d.d00);
    if (dot(d.a, side_0).sign() != 0)
        return true;
    return disagree(side_0, cross(d.d10, d.b)) || disagree(cross(d.a, d.d00), cross(d.d01, d.a));
}

/// The step with every coordinate times 2^exponent.
VertexFaceStep scaled(const VertexFaceStep& s, int exponent)
{
    const auto scale = [exponent](const Vec3& p) -> Vec3 { return p.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); }); };
    return {scale(s.v_t0), scale(s.f0_t0), scale(s.f1_t0), scale(s.f2_t0),
            scale(s.v_t1), scale(s.f0_t1), scale(s.f1_t1), scale(s.f2_t1)};
}

EdgeEdgeStep scaled(const EdgeEdgeStep& s, int exponent)
{
    const auto scale = [exponent](const Vec3& p) -> Vec3 { return p.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); }); };
    return {scale(s.ea0_t0), scale(s.ea1_t0), scale(s.eb0_t0), scale(s.eb1_t0),
            scale(s.ea0_t1), scale(s.ea1_t1), scale(s.eb0_t1), scale(s.eb1_t1)};
}

bool finite(const VertexFaceStep& s)
{
    return s.v_t0.allFinite() && s.f0_t0.allFinite() && s.f1_t0.allFinite() && s.f2_t0.allFinite() &&
           s.v_t1.allFinite() && s.f0_t1.allFinite() && s.f1_t1.allFinite() && s.f2_t1.allFinite();
}

bool finite(const EdgeEdgeStep& s)
{
    return s.ea0_t0.allFinite() && s.ea1_t0.allFinite() && s.eb0_t0.allFinite() && s.eb1_t0.allFinite() &&
           s.ea0_t1.allFinite() && s.ea1_t1.allFinite() && s.eb0_t1.allFinite() && s.eb1_t1.allFinite();
}

template <template <class> class Differences, class Step>
std::optional<double> first_touch(const Step& step, double start);

/// Brings the step to a size at which products are safe. A power of two changes no digit of what matters.
template <template <class> class Differences, class Step>
std::optional<double> first_touch_rescaled(const Step& step, double start, double size)
{
    if (!finite(step))
        throw std::invalid_argument("time_of_impact: every coordinate must be finite");
    if (size == 0)
        return start;  // all differences vanish throughout: the features share a point
    const int down = std::isfinite(size) ? -std::ilogb(size) : -4;
    return first_touch<Differences>(scaled(step, down), start);
}

//! [stages]
template <template <class> class Differences, class Step>
std::optional<double> first_touch(const Step& step, double start)
{
    const Differences<double> quick(step);
    const double size = quick.size();
    if (!(size > smallest_size && size < largest_size))
        return first_touch_rescaled<Differences>(step, start, size);
    if (apart_at_first_glance(quick))
        return std::nullopt;

    Touch touch = search(quick, start);
    if (touch.verdict == Verdict::open)
        touch = search(Differences<DoubleDouble>(step), start);
    if (touch.verdict == Verdict::apart)
        return std::nullopt;
    return start + (1 - start) * touch.time;
}
//! [stages]

void require_part_of_step(double from)
{
    if (!(from >= 0 && from <= 1))
        throw std::invalid_argument("time_of_impact: from = " + std::to_string(from) + " must lie in [0, 1]");
}

}  // namespace

std::optional<double> time_of_impact(const VertexFaceStep& step) { return first_touch<VertexFaceDifferences>(step, 0); }
std::optional<double> time_of_impact(const EdgeEdgeStep& step) { return first_touch<EdgeEdgeDifferences>(step, 0); }

std::optional<double> time_of_impact(const VertexFaceStep& step, double from)
{
    require_part_of_step(from);
    return first_touch<VertexFaceDifferences>(step, from);
}

std::optional<double> time_of_impact(const EdgeEdgeStep& step, double from)
{
    require_part_of_step(from);
    return first_touch<EdgeEdgeDifferences>(step, from);
}

}  // namespace enduring
