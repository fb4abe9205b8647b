#include "chapters/13_other_solvers/impedance.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

constexpr double no_force = 1e300;  ///< free velocity with which nothing pushes, whatever moves [m/s]

}  // namespace

double impedance(const ImpedanceSettings& settings, double depth)
{
    const double x = std::min(1.0, std::abs(depth) / settings.width);
    const double part = x < 0.5 ? 2 * x * x : 1 - 2 * (1 - x) * (1 - x);
    return settings.least + part * (settings.most - settings.least);
}

//! [impedance_contact]
RegularisedContact impedance_contact(const ImpedanceSettings& settings, double separation,
                                     const Vec3& velocity, double inverse_mass, double mu, double dt)
{
    if (separation >= 0)
        return {1, 1, -no_force, mu};
    const double d = impedance(settings, separation), t = settings.most * settings.time_constant,
                 zeta = settings.damping_ratio;
    const double b = 2 / t, k = d / (t * t * zeta * zeta);
    const double r = (1 - d) / d * (1 + mu * mu) * inverse_mass;
    const Vec3 free = velocity - dt * (b * velocity + k * separation * Vec3::UnitX());
    // a pyramid without width is a normal alone
    const double of_edges = mu > 0 ? mu * mu / 2 : 1;
    return {of_edges * r, r, free.x(), mu, free.tail<2>()};
}
//! [impedance_contact]

}  // namespace enduring
