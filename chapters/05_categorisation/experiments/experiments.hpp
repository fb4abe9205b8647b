#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter05 {

void spans(const RunOptions& options, Report& report);
void edge_rule(const RunOptions& options, Report& report);
void ambiguity(const RunOptions& options, Report& report);
void sliding_categories(const RunOptions& options, Report& report);
void dropping(const RunOptions& options, Report& report);

}  // namespace enduring::chapter05
