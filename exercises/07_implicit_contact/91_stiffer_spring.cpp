#include "exercises/07_implicit_contact/91_stiffer_spring.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {

double asked_stiffness(const Pair& pair, double dt)
{
    not_implemented_yet("7.91");
}

double energy(const Spring& spring, double depth)
{
    not_implemented_yet("7.91");
}

Spring with_stiffness(const Spring& spring, double k, double depth)
{
    not_implemented_yet("7.91");
}

Spring adapted(const Spring& spring, const Pair& pair, double depth, double dt)
{
    not_implemented_yet("7.91");
}

double faded(double rest, double fastest, double dt)
{
    not_implemented_yet("7.91");
}

}  // namespace enduring
