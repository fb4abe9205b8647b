#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter08 {

void heap(const RunOptions& options, Report& report);
void families(const RunOptions& options, Report& report);
void ridges(const RunOptions& options, Report& report);
void fast(const RunOptions& options, Report& report);

}  // namespace enduring::chapter08
