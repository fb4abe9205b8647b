#include "chapters/02_collision_detection/textbook.hpp"

#include "chapters/02_collision_detection/cubic_roots.hpp"

#include <algorithm>

namespace enduring {
namespace {

/// A vector that changes linearly with time: at + tau * rate.
struct Linear {
    Vec3 at, rate;

    Linear(const Vec3& start, const Vec3& end) : at(start), rate(end - start) {}
    Vec3 operator()(double tau) const { return at + tau * rate; }
};

//! [cubic]
/// Coefficients of (a x b) . c in powers of tau, lowest first: the volume
/// of a, b, c, zero where they lie in one plane.
std::array<double, 4> volume(const Linear& a, const Linear& b, const Linear& c)
{
    const Vec3 n0 = a.at.cross(b.at), n1 = a.at.cross(b.rate) + a.rate.cross(b.at), n2 = a.rate.cross(b.rate);
    return {n0.dot(c.at), n0.dot(c.rate) + n1.dot(c.at), n1.dot(c.rate) + n2.dot(c.at), n2.dot(c.rate)};
}
//! [cubic]

bool in_unit_interval(double value, double tolerance)
{
    return value >= -tolerance && value <= 1 + tolerance;
}

/// The first root in the step at which `inside` holds.
template <class Inside>
std::optional<double> first_root(const std::array<double, 4>& cubic, const TextbookTolerances& tolerances,
                                 const Inside& inside)
{
    for (const double tau : cubic_roots(cubic, tolerances.coefficient))
        if (in_unit_interval(tau, tolerances.time) && inside(tau))
            return std::clamp(tau, 0.0, 1.0);
    return std::nullopt;
}

}  // namespace

//! [vertex_face]
std::optional<double> textbook_time_of_impact(const VertexFaceStep& s, const TextbookTolerances& tolerances)
{
    const Linear b(s.f1_t0 - s.f0_t0, s.f1_t1 - s.f0_t1);
    const Linear c(s.f2_t0 - s.f0_t0, s.f2_t1 - s.f0_t1);
    const Linear p(s.v_t0 - s.f0_t0, s.v_t1 - s.f0_t1);

    return first_root(volume(b, c, p), tolerances, [&](double tau) {
        const Vec3 normal = b(tau).cross(c(tau));
        const double w1 = p(tau).cross(c(tau)).dot(normal) / normal.squaredNorm();
        const double w2 = b(tau).cross(p(tau)).dot(normal) / normal.squaredNorm();
        return w1 >= -tolerances.weight && w2 >= -tolerances.weight && w1 + w2 <= 1 + tolerances.weight;
    });
}
//! [vertex_face]

std::optional<double> textbook_time_of_impact(const EdgeEdgeStep& s, const TextbookTolerances& tolerances)
{
    const Linear a(s.ea1_t0 - s.ea0_t0, s.ea1_t1 - s.ea0_t1);
    const Linear b(s.eb1_t0 - s.eb0_t0, s.eb1_t1 - s.eb0_t1);
    const Linear r(s.eb0_t0 - s.ea0_t0, s.eb0_t1 - s.ea0_t1);

    return first_root(volume(a, b, r), tolerances, [&](double tau) {
        const Vec3 normal = a(tau).cross(b(tau));
        const double w_a = r(tau).cross(b(tau)).dot(normal) / normal.squaredNorm();
        const double w_b = r(tau).cross(a(tau)).dot(normal) / normal.squaredNorm();
        return in_unit_interval(w_a, tolerances.weight) && in_unit_interval(w_b, tolerances.weight);
    });
}

}  // namespace enduring
