#include "chapters/01_particle_plane/plane_impulse.hpp"
#include "exercises/not_implemented_yet.hpp"

namespace enduring {

double discrete_plane_impulse(double depth_t1, double k, double dt)
{
    not_implemented_yet("1.1");
}

std::optional<PlaneInterval> find_plane_interval(double depth_t0, double depth_t1)
{
    not_implemented_yet("1.1");
}

double continuous_plane_impulse(double depth_t0, double depth_t1, double k, double dt)
{
    not_implemented_yet("1.1");
}

}  // namespace enduring
