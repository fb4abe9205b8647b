#pragma once

#include "chapters/08_speculative_contacts/experiments/forces_rows.hpp"

namespace enduring::chapter08::force_rows {

/// The rows of one kind of scene under a solver, of the small or of the full set.
using Kind = Rows (*)(const MakeSolver& make, bool full);

/// All kinds of the experiment, in its order.
const std::vector<Kind>& all_kinds();

}  // namespace enduring::chapter08::force_rows
