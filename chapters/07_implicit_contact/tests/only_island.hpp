#pragma once

#include "chapters/07_implicit_contact/step_problem.hpp"

#include <doctest/doctest.h>

namespace enduring {

/// The problem of a scene in which all that takes part is one island; without rows where nothing does.
inline StepProblem set_up_only_island(const World& world, Contacts& contacts, const StiffnessChoice& choice,
                                      const FrictionCoefficients& friction, const StepLaw& step, bool first)
{
    const std::vector<Island> islands = find_islands(world, contacts);
    REQUIRE(islands.size() <= 1);
    return set_up(world, islands.empty() ? Island{} : islands.front(), choice, friction, step, first);
}

}  // namespace enduring
