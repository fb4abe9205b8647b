#include "chapters/02_collision_detection/textbook.hpp"

#include "chapters/02_collision_detection/cubic_roots.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {
namespace {

/// A vector that changes linearly with time: at + tau * rate.
struct Linear {
    Vec3 at, rate;

    Linear(const Vec3& start, const Vec3& end) : at(start), rate(end - start) {}
    Vec3 operator()(double tau) const { return at + tau * rate; }
};

/// Coefficients of (a x b) . c in powers of tau, lowest first: the volume
/// of a, b, c, zero where they lie in one plane.
std::array<double, 4> volume(const Linear& a, const Linear& b, const Linear& c)
{
    not_implemented_yet("2.1");
}

bool in_unit_interval(double value, double tolerance)
{
    return value >= -tolerance && value <= 1 + tolerance;
}

/// The first root in the step at which `inside` holds.
template <class Inside>
std::optional<double> first_root(const std::array<double, 4>& cubic, const TextbookTolerances& tolerances,
                                 const Inside& inside)
{
    not_implemented_yet("2.1");
}

}  // namespace

std::optional<double> textbook_time_of_impact(const VertexFaceStep& s, const TextbookTolerances& tolerances)
{
    not_implemented_yet("2.1");
}

std::optional<double> textbook_time_of_impact(const EdgeEdgeStep& s, const TextbookTolerances& tolerances)
{
    not_implemented_yet("2.1");
}

}  // namespace enduring
