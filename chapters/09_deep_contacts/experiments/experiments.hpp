#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter09 {

void deep(const RunOptions& options, Report& report);
void tracing(const RunOptions& options, Report& report);
void bunny_curve(const RunOptions& options, Report& report);
void separation_direction(const RunOptions& options, Report& report);
void initial_overlap(const RunOptions& options, Report& report);
void crossed_beams(const RunOptions& options, Report& report);
void born_loaded(const RunOptions& options, Report& report);
void separation_methods(const RunOptions& options, Report& report);
void thin(const RunOptions& options, Report& report);
void missed_vertices(const RunOptions& options, Report& report);
void squeezed(const RunOptions& options, Report& report);
void mass_ratios(const RunOptions& options, Report& report);
void cost(const RunOptions& options, Report& report);

}  // namespace enduring::chapter09
