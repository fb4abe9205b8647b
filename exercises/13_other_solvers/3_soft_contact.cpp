#include "exercises/13_other_solvers/3_soft_contact.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring {

double implicit_speed(double hertz, double damping_ratio, double h, double separation, double speed)
{
    not_implemented_yet("13.3");
}

SoftNumbers soft_numbers(double hertz, double damping_ratio, double h)
{
    not_implemented_yet("13.3");
}

double change_of_impulse(const SoftNumbers& soft, double mass, double separation, double speed, double sum)
{
    not_implemented_yet("13.3");
}

FallingMass soft_step(FallingMass body, double hertz, double damping_ratio, double dt, int substeps)
{
    not_implemented_yet("13.3");
}

double time_to_part(const SoftNumbers& soft, double part)
{
    not_implemented_yet("13.3");
}

}  // namespace enduring
