#include "exercises/10_self_contact/2_corners.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace enduring {

double predicted_turns()
{
    not_implemented_yet("10.2");
}

double corner_factor(double mu, double turn)
{
    not_implemented_yet("10.2");
}

double post_factor(double mu, double angle, int corners)
{
    not_implemented_yet("10.2");
}

double capstan_factor(double mu, double angle)
{
    not_implemented_yet("10.2");
}

double turns_for(double mu, double ratio)
{
    not_implemented_yet("10.2");
}

int corners_needed(double mu, double angle, double error)
{
    not_implemented_yet("10.2");
}

}  // namespace enduring
