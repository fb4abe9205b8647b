#include "exercises/01_particle_plane/2_restitution.hpp"

#include "chapters/01_particle_plane/plane_impulse.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring {

double damped_plane_impulse(double depth_t0, double depth_t1, double k, double c, double dt)
{
    not_implemented_yet("1.2");
}

double damper_for_restitution(double restitution, double mass, double k, double dt)
{
    not_implemented_yet("1.2");
}

double kept_by_a_bounce(double speed, double mass, double k, double c, double dt)
{
    not_implemented_yet("1.2");
}

}  // namespace enduring
