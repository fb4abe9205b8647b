#include "exercises/10_self_contact/2_corners.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace enduring {

double predicted_turns() { return 1; }

// With the angle of friction, mu = tan(phi): the push of the post leans by phi from the bisector, and the law
// of sines gives the pulls.
double corner_factor(double mu, double turn)
{
    const double lean = std::atan(mu), left = std::cos(turn / 2 + lean);
    if (left <= 0)
        return std::numeric_limits<double>::infinity();
    return std::cos(turn / 2 - lean) / left;
}

double post_factor(double mu, double angle, int corners)
{
    double factor = 1;
    for (int corner = 0; corner < corners; ++corner)
        factor *= corner_factor(mu, angle / corners);
    return factor;
}

double capstan_factor(double mu, double angle) { return std::exp2(mu * angle / std::numbers::ln2); }

double turns_for(double mu, double ratio)
{
    return std::log2(ratio) * std::numbers::ln2 / (2 * std::numbers::pi * mu);
}

int corners_needed(double mu, double angle, double error)
{
    int corners = 1;
    for (; corners < 10000; ++corners)
        if (post_factor(mu, angle, corners) / capstan_factor(mu, angle) - 1 <= error)
            break;
    return corners;
}

}  // namespace enduring
