#pragma once

#include "common/experiments/report/report.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Runs the worked step under a solver and writes a page table for each array, with a column (of contacts: a
/// row) for each stage that changed it: worked_step_velocities, worked_step_predictions,
/// worked_step_positions (y only; x and z never change) and worked_step_contacts.
void write_worked_step(const Solver& solver, Report& report);

}  // namespace enduring
