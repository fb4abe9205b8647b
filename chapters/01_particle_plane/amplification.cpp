#include "chapters/01_particle_plane/amplification.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace enduring {

//! [amplification]
double look_ahead(PenaltyMethod method) { return method == PenaltyMethod::discrete ? 1.0 : 0.5; }

Eigen::Matrix2d amplification(PenaltyMethod method, double mass, double stiffness, double dt)
{
    const double h = stiffness * dt * dt / mass;
    const double ah = look_ahead(method) * h;
    Eigen::Matrix2d a;
    a << 1 - h, dt * (1 - ah), -h / dt, 1 - ah;
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

//! [critical_step]
double critical_step(PenaltyMethod method, double mass, double stiffness)
{
    const double largest_h = 4 / (1 + 2 * look_ahead(method));
    return std::sqrt(largest_h * mass / stiffness);
}
//! [critical_step]

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
