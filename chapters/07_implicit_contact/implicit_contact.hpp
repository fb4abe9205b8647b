#pragma once

#include "chapters/07_implicit_contact/newton_matrix.hpp"
#include "chapters/07_implicit_contact/step_problem.hpp"

#include <functional>

namespace enduring {

/// How the one problem of a step was solved.
struct SolveRecord {
    int step = 0;
    int pairs = 0;
    int rounds = 0;        ///< how often the problem was set up anew from the motion that its answer made
    int newton_steps = 0;  ///< of all rounds
    /// of the last problem, with friction's limits and the normals as its answer made them
    double residual = 0;
    bool turns_too_far = false;  ///< a body, so that the answer was thrown away for a safe one
    bool converged = false;
};

/// Says on the standard error stream which step is not solved, and how well it is.
void tell_unconverged(const SolveRecord& record);

//! [settings]
/// The same for all scenes but for the coefficients of friction, which are the scene's.
struct ImplicitSettings {
    StiffnessChoice stiffness;
    FrictionCoefficients friction;
    double centre = 1;        ///< of the weight over the step
    double tolerance = 1e-6;  ///< of the residual
    /// Of Newton's method in a step, over all its responses, rounds, limits and problems. What is unsolved then is
    /// told, and answered safely where more than a hundredth is left. Landing soft bodies take some hundreds: a tenth
    /// of it would cut these off; with ten times as many a heap that jams takes ten seconds for such a step.
    int most_newton_steps = 500;
    std::function<void(const SolveRecord&)> record = tell_unconverged;
};
//! [settings]

/// Response: finds the impulses of all pairs together, from the motion that they make, and applies them.
/// @param matrix  keeps its memory and its order from step to step
void answer_all_pairs(World& world, Contacts& contacts, const ImplicitSettings& settings,
                      NewtonMatrix& matrix, double dt);

/// Before the step is settled: what each pair hands on to the next one,
/// its load and the stretch of its friction. One that is held holds nothing: its spring has let go.
void remember_pairs(const World& world, Contacts& contacts, double dt);

}  // namespace enduring
