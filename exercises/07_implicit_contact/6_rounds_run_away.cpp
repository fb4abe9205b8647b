#include "exercises/07_implicit_contact/6_rounds_run_away.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>

namespace enduring {

WedgeMotion solved_with(const Wedge& wedge, double limit)
{
    not_implemented_yet("7.6");
}

int rounds_needed(const Wedge& wedge, double part, double tolerance, int most)
{
    not_implemented_yet("7.6");
}

double factor_of_a_round(const Wedge& wedge)
{
    not_implemented_yet("7.6");
}

double best_part(const Wedge& wedge)
{
    not_implemented_yet("7.6");
}

double predicted_mu(double angle)
{
    not_implemented_yet("7.6");
}

}  // namespace enduring
