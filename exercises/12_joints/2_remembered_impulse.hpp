#pragma once

#include <vector>

namespace enduring {

/// A body on a straight rail. A joint holds it at the position 0, and a load pulls at it for the whole step.
struct Held {
    double mass = 1;      ///< [kg]
    double place = 0;     ///< at the start of the step [m]
    double velocity = 0;  ///< at the start of the step [m/s]
    double load = 0;      ///< [N]
    double dt = 0.01;     ///< length of the step [s]
    double h = 10;        ///< k dt^2 / m of the joint's spring
};

/// The position of the body at the end of the step if the joint applies this impulse [m].
double place_after(const Held& body, double impulse);

/// One round: the joint begins with the impulse p of the last round, and its spring pushes against the error
/// that this round leaves.
/// @return  the impulse p_new with  p_new = p - k dt place_after(p_new)  [N s]
double next_impulse(const Held& body, double p);

/// The error at the end of the step [m] after each of the rounds. The first round begins with the impulse
/// `begin` [N s].
std::vector<double> errors(const Held& body, double begin, int rounds);

/// The number of rounds, beginning with no impulse, until the error is at most `tolerance` [m]; 0 if it is
/// already so without an impulse.
int rounds_needed(const Held& body, double tolerance);

}  // namespace enduring
