#include "exercises/11_exact_contact/3_relaxed_lift.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

Vec3 relaxed_impulse(const Vec3& free_velocity, double mass, double mu)
{
    not_implemented_yet("11.3");
}

double rising_speed(const Vec3& free_velocity, double mass, double mu)
{
    not_implemented_yet("11.3");
}

double gap_after(const BlockOverGround& block, double mu, double dt)
{
    not_implemented_yet("11.3");
}

double floating_gap(double speed, double mu, double dt)
{
    not_implemented_yet("11.3");
}

}  // namespace enduring
