#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter01 {

void two_looks(const RunOptions& options, Report& report);
void stability_map(const RunOptions& options, Report& report);
void critical_step(const RunOptions& options, Report& report);
void drop(const RunOptions& options, Report& report);
void damping(const RunOptions& options, Report& report);
void ground(const RunOptions& options, Report& report);

}  // namespace enduring::chapter01
