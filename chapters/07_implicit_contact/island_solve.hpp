#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"

namespace enduring {

/// What is found out about an island, beside its impulses.
struct IslandOutcome {
    SolveRecord record{};
    StepTrouble trouble = StepTrouble::none;
    bool is_lagged = false;   ///< its friction has the limits of the last round, which were not its own
    bool is_held_up = false;  ///< joints hold it, and what they push is not found: nothing pushes it
    double springs = 0;  ///< what they hold at the start of the step, where this is its first response [J]
    int solves = 0;      ///< of Newton's matrix in this response
};

/// Finds the impulses of one island, and applies them. Changes the island's bodies and pairs only, and reads
/// what does not move.
/// @param matrix  of this island; counts the solves of the attempt
/// @param first   the first response of the step
IslandOutcome solve_island(World& world, const Island& island, const ImplicitSettings& settings,
                           NewtonMatrix& matrix, const Allowance& allowed, bool first, double dt);

}  // namespace enduring
