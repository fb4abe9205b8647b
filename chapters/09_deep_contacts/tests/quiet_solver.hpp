#pragma once

#include "chapters/09_deep_contacts/solver.hpp"

namespace enduring::chapter09 {

/// This chapter's solver, with nothing told on stderr.
inline Solver quiet_solver(const ContactParameters& parameters)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    return chapter09_solver(parameters, settings);
}

}  // namespace enduring::chapter09
