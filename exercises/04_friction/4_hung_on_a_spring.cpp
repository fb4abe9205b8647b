#include "exercises/04_friction/4_hung_on_a_spring.hpp"

#include "chapters/04_friction/friction_law.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>

namespace enduring {

double predicted_ratio()
{
    not_implemented_yet("4.4");
}

bool holds_the_block(double ratio, double damping)
{
    not_implemented_yet("4.4");
}

double smallest_ratio(double damping)
{
    not_implemented_yet("4.4");
}

double overshoot_law(double damping)
{
    not_implemented_yet("4.4");
}

}  // namespace enduring
