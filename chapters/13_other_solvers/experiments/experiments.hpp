#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter13 {

void same_scenes(const RunOptions& options, Report& report);
void over_iterations(const RunOptions& options, Report& report);
void soft_bodies(const RunOptions& options, Report& report);
void pair_forces(const RunOptions& options, Report& report);
void ledger_scenes(const RunOptions& options, Report& report);
void heap(const RunOptions& options, Report& report);
void bunny_bowl(const RunOptions& options, Report& report);
void growth(const RunOptions& options, Report& report);
void beside_engines(const RunOptions& options, Report& report);

}  // namespace enduring::chapter13
