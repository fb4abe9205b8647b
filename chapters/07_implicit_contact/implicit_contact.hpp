#pragma once

#include "chapters/07_implicit_contact/pair_memory.hpp"
#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

#include <functional>

namespace enduring {

/// How the one problem of a step was solved.
struct SolveRecord {
    int step = 0;
    int rounds = 0;        ///< how often the problem was set up anew from the motion that its answer made
    int newton_steps = 0;  ///< of all rounds
    int pairs = 0;
    /// of the last problem, with its friction limits and normals as the answer made them
    double residual = 0;
    bool converged = false;
};

struct ImplicitSettings {
    StiffnessChoice stiffness;
    double centre = 1;  ///< of the weight over the step
    double mu_s = 0, mu_d = 0;
    double tolerance = 1e-6;  ///< of the residual
    int most_rounds = 30;
    std::function<void(const SolveRecord&)> record = [](const SolveRecord&) {};
};

/// Response: finds the impulses of all pairs together, from the motion that they make, and applies them.
void answer_all_pairs(World& world, Contacts& contacts, const ImplicitSettings& settings, double dt);

/// Before the step is settled: what each pair hands on to the next one,
/// its load and the stretch of its friction.
void remember_pairs(const World& world, Contacts& contacts, double dt);

}  // namespace enduring
