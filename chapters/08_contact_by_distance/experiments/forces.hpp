#pragma once

#include "chapters/08_contact_by_distance/experiments/forces_rows.hpp"
#include "common/experiments/report/report.hpp"

#include <string>
#include <vector>

namespace enduring::chapter08::force_rows {

/// The rows of one kind of scene under a solver, of the small or of the full set.
using Kind = Rows (*)(const MakeSolver& make, bool full);

/// All kinds of the experiment, in its order.
const std::vector<Kind>& all_kinds();
/// What given motion presses farther than both skins, for a solver that takes bodies which overlap.
const std::vector<Kind>& squeezed_kinds();

/// Runs the kinds and writes their rows: a table, and the same as facts of this name.
void report_rows(Report& report, const std::string& name, const std::vector<Kind>& kinds,
                 const MakeSolver& make, bool full);

}  // namespace enduring::chapter08::force_rows
