#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter09 {

void deep(const RunOptions& options, Report& report);
void tracing(const RunOptions& options, Report& report);
void bunny_curve(const RunOptions& options, Report& report);
void way_out(const RunOptions& options, Report& report);
void born_inside(const RunOptions& options, Report& report);
void crossed_beams(const RunOptions& options, Report& report);
void born_loaded(const RunOptions& options, Report& report);
void ways_compared(const RunOptions& options, Report& report);
void thin(const RunOptions& options, Report& report);
void unpaired(const RunOptions& options, Report& report);
void folding(const RunOptions& options, Report& report);
void knot(const RunOptions& options, Report& report);
void round_turns(const RunOptions& options, Report& report);
void mass_ratios(const RunOptions& options, Report& report);
void cost(const RunOptions& options, Report& report);

}  // namespace enduring::chapter09
