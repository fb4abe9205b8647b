#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter10 {

void folding(const RunOptions& options, Report& report);
void knot(const RunOptions& options, Report& report);
void capstan(const RunOptions& options, Report& report);
void cost(const RunOptions& options, Report& report);

}  // namespace enduring::chapter10
