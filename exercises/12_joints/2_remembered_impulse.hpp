#pragma once

#include <vector>

namespace enduring {

/// A body on a straight rail, which a joint holds at the place 0. A load pulls at it for the whole step.
struct Held {
    double mass = 1;      ///< [kg]
    double place = 0;     ///< where the step begins [m]
    double velocity = 0;  ///< the same [m/s]
    double load = 0;      ///< [N]
    double dt = 0.01;     ///< length of the step [s]
    double h = 10;        ///< k dt^2 / m of the joint's spring
};

/// Where the body is at the end of the step if the joint gives an impulse [m].
double place_after(const Held& body, double impulse);

/// One round: the joint begins with the impulse p of the last round, and its spring pushes against the error
/// at the end of this round.
/// @return  the impulse p_new with  p_new = p - k dt place_after(p_new)  [N s]
double next_impulse(const Held& body, double p);

/// The error at the end of the step [m] after each of some rounds, of which the first begins with the impulse
/// `begin` [N s].
std::vector<double> errors(const Held& body, double begin, int rounds);

/// How many rounds, beginning with no impulse, it takes until the error is no more than `tolerance` [m]; 0 if
/// it is so without any impulse.
int rounds_needed(const Held& body, double tolerance);

}  // namespace enduring
