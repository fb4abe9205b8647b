#include "exercises/10_self_contact/2_corners.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace enduring {

double predicted_turns() { return 1; }

double corner_factor(double mu, double turn)
{
    // The bisector carries (F1 + F2) sin(turn / 2), and friction holds (F1 - F2) cos(turn / 2).
    const double pressed = mu * std::sin(turn / 2);
    const double apart = std::cos(turn / 2);
    if (pressed >= apart)
        return std::numeric_limits<double>::infinity();
    return (apart + pressed) / (apart - pressed);
}

double post_factor(double mu, double angle, int corners)
{
    const double of_one = corner_factor(mu, angle / corners);
    return std::pow(of_one, corners);
}

double capstan_factor(double mu, double angle) { return std::exp(mu * angle); }

double turns_for(double mu, double ratio)
{
    const double of_one_turn = mu * 2 * std::numbers::pi;
    return std::log(ratio) / of_one_turn;
}

int corners_needed(double mu, double angle, double error)
{
    const double round = capstan_factor(mu, angle);
    int corners = 1;
    while (corners < 10000 && !(post_factor(mu, angle, corners) <= (1 + error) * round))
        ++corners;
    return corners;
}

}  // namespace enduring
