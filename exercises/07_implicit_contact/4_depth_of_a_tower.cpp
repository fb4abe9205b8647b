#include "exercises/07_implicit_contact/4_depth_of_a_tower.hpp"

#include "chapters/07_implicit_contact/solver.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>

namespace enduring {

double predicted_factor()
{
    not_implemented_yet("7.4");
}

std::vector<double> loads_of(const Tower& tower)
{
    not_implemented_yet("7.4");
}

double mass_of_pair(const Tower& tower, std::size_t joint)
{
    not_implemented_yet("7.4");
}

std::vector<double> law_of_depths(const Tower& tower, const StiffnessChoice& choice, double dt)
{
    not_implemented_yet("7.4");
}

std::vector<double> measured_depths(const Tower& tower, const StiffnessChoice& choice, double dt,
                                    double seconds)
{
    not_implemented_yet("7.4");
}

}  // namespace enduring
