#include "exercises/08_speculative_contacts/1_margin.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {

double predicted_millimetres()
{
    not_implemented_yet("8.1");
}

double fall_from_rest(double gravity, double dt, int steps)
{
    not_implemented_yet("8.1");
}

double margin_of(double gravity, double dt, double smallest, double fall, double nearness)
{
    not_implemented_yet("8.1");
}

Approach after_a_step(const Approach& approach, double gravity, double dt)
{
    not_implemented_yet("8.1");
}

Found find_pair(const Approach& approach, double gravity, double dt, double margin)
{
    not_implemented_yet("8.1");
}

double depth_when_found(Approach approach, double gravity, double dt, double margin)
{
    not_implemented_yet("8.1");
}

}  // namespace enduring
