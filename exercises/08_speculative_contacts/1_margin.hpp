#pragma once

namespace enduring {

/// A vertex over a floor, at the start of a step.
struct Approach {
    double gap;    ///< to the floor, positive outside [m]
    double speed;  ///< towards the floor [m/s]
};

/// How a pair of the two is found.
enum class Found {
    not_at_all,  ///< nothing brings them together in this step
    near_start,  ///< they are near at its start
    crossing     ///< the vertex passes the floor within it
};

/// Your prediction: how many millimetres a body falls from rest in one step of 0.01 s. Not judged; positive.
double predicted_millimetres();

/// How far a body falls from rest in some steps of the course's scheme: the velocity first, then the position with this
/// velocity [m].
double fall_from_rest(double gravity, double dt, int steps);

/// From how far pairs have to be made [m]: `fall` times what a body at rest falls in a step, and never less than
/// `nearness` times the size of the smallest body.
double margin_of(double gravity, double dt, double smallest, double fall, double nearness);

/// Where the vertex is a step later, if nothing pushes it.
Approach after_a_step(const Approach& approach, double gravity, double dt);

/// Which of the two questions finds the pair in this step, asked in this order: near at the start (or inside), or a
/// crossing within the step. Exactly on the margin is near.
Found find_pair(const Approach& approach, double gravity, double dt, double margin);

/// A search that asks the first question only: how deep has the vertex come when this search first finds it? It moves
/// freely until then, from the approach given. 0 if it is found outside.
double depth_when_found(Approach approach, double gravity, double dt, double margin);

}  // namespace enduring
