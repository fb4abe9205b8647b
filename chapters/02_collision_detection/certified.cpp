#include "chapters/02_collision_detection/certified.hpp"

#include "chapters/02_collision_detection/first_touch.hpp"

#include <stdexcept>
#include <string>

namespace enduring {
namespace {

using namespace certified;

/// Coordinate differences of this size neither overflow nor underflow in a product of four.
constexpr double smallest_size = 0x1p-200, largest_size = 0x1p200;

/// The step with every coordinate times 2^exponent.
VertexFaceStep scaled(const VertexFaceStep& s, int exponent)
{
    const auto scale = [exponent](const Vec3& p) -> Vec3 {
        return p.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); });
    };
    return {scale(s.v_t0), scale(s.f0_t0), scale(s.f1_t0), scale(s.f2_t0),
            scale(s.v_t1), scale(s.f0_t1), scale(s.f1_t1), scale(s.f2_t1)};
}

EdgeEdgeStep scaled(const EdgeEdgeStep& s, int exponent)
{
    const auto scale = [exponent](const Vec3& p) -> Vec3 {
        return p.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); });
    };
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

template <class Step>
CertifiedAnswer first_touch_of(const Step& step, double start);

/// Brings the step to a size at which products are safe. A power of two changes no digit of what matters.
template <class Step>
CertifiedAnswer first_touch_rescaled(const Step& step, double start, double size)
{
    if (!finite(step))
        throw std::invalid_argument("time_of_impact: every coordinate must be finite");
    if (size == 0)
        return {start, QueryStage::height};  // all differences vanish throughout: the features share a point
    const int down = std::isfinite(size) ? -std::ilogb(size) : -4;
    return first_touch_of(scaled(step, down), start);
}

//! [stages]
template <class Step>
CertifiedAnswer first_touch_of(const Step& step, double start)
{
    const auto quick = differences<double>(step);
    if (!(size(quick) > smallest_size && size(quick) < largest_size))
        return first_touch_rescaled(step, start, size(quick));
    const auto volume = height(quick);
    if (volume.sign() != 0)
        return {std::nullopt, QueryStage::height};  // most pairs end here
    if (boxes_apart(quick))
        return {std::nullopt, QueryStage::doubles};

    Touch<double> touch{Verdict::open, start};
    if (start == 0 && volume.sign(0) != 0)
        touch = touch_at_root(quick, volume);
    if (touch.verdict == Verdict::open)
        touch = first_touch(quick, touch.time);
    if (touch.verdict == Verdict::apart)
        return {std::nullopt, QueryStage::doubles};
    if (touch.verdict == Verdict::touch)
        return {touch.time, QueryStage::doubles};
    const auto fine = differences<DoubleDouble>(step);
    if (touches_in_plane(quick, fine, touch.time))
        return {touch.time, QueryStage::double_doubles};
    const auto last = first_touch(fine, DoubleDouble(touch.time));
    if (last.verdict == Verdict::apart)
        return {std::nullopt, QueryStage::double_doubles};
    return {rounded(last.time), QueryStage::double_doubles};
}
//! [stages]

void require_part_of_step(double from)
{
    if (!(from >= 0 && from <= 1))
        throw std::invalid_argument("time_of_impact: from = " + std::to_string(from) + " must lie in [0, 1]");
}

}  // namespace

CertifiedAnswer certified_answer(const VertexFaceStep& step) { return first_touch_of(step, 0); }
CertifiedAnswer certified_answer(const EdgeEdgeStep& step) { return first_touch_of(step, 0); }

std::optional<double> time_of_impact(const VertexFaceStep& step) { return first_touch_of(step, 0).time; }
std::optional<double> time_of_impact(const EdgeEdgeStep& step) { return first_touch_of(step, 0).time; }

std::optional<double> time_of_impact(const VertexFaceStep& step, double from)
{
    require_part_of_step(from);
    return first_touch_of(step, from).time;
}

std::optional<double> time_of_impact(const EdgeEdgeStep& step, double from)
{
    require_part_of_step(from);
    return first_touch_of(step, from).time;
}

}  // namespace enduring
