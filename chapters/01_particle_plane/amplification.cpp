#include "amplification.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace enduring {

//! [amplification]
Eigen::Matrix2d amplification(PenaltyMethod method, double mass, double stiffness, double dt)
{
    const double h = stiffness * dt * dt / mass;
    const double look_ahead = method == PenaltyMethod::discrete ? 1.0 : 0.5;  // in steps: where the depth is taken
    Eigen::Matrix2d a;
    a << 1 - h,  dt * (1 - look_ahead * h),
        -h / dt, 1 - look_ahead * h;
    return a;
}
//! [amplification]

//! [spectral_radius]
double spectral_radius(const Eigen::Matrix2d& a)
{
    const double half_trace = 0.5 * a.trace(), determinant = a.determinant();
    const double discriminant = half_trace * half_trace - determinant;
    if (discriminant < 0)
        return std::sqrt(determinant);  // a conjugate pair, whose product is the determinant
    return std::abs(half_trace) + std::sqrt(discriminant);
}
//! [spectral_radius]

double critical_step(PenaltyMethod method, double mass, double stiffness)
{
    const double limit = method == PenaltyMethod::discrete ? 4.0 / 3.0 : 2.0;  // of h = k dt^2 / m
    return std::sqrt(limit * mass / stiffness);
}

Decay decay(const Eigen::Matrix2d& a)
{
    const double determinant = a.determinant(), half_trace = 0.5 * a.trace();
    if (!(half_trace * half_trace < determinant))
        throw std::domain_error("real eigenvalues: nothing swings");
    Decay result;
    result.per_step = std::sqrt(determinant);
    result.steps_per_contact = std::numbers::pi / std::acos(half_trace / result.per_step);
    result.per_contact = std::pow(result.per_step, result.steps_per_contact);
    return result;
}

}  // namespace enduring
