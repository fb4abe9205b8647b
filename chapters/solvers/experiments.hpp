#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::solvers {

void passes(const RunOptions& options, Report& report);
void ledger(const RunOptions& options, Report& report);
void speed(const RunOptions& options, Report& report);

}  // namespace enduring::solvers
