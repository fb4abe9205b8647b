#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter07 {

void implicit_map(const RunOptions& options, Report& report);
void residual(const RunOptions& options, Report& report);
void ring(const RunOptions& options, Report& report);
void free_bounce(const RunOptions& options, Report& report);
void stack(const RunOptions& options, Report& report);
void scales(const RunOptions& options, Report& report);
void slope(const RunOptions& options, Report& report);
void soft_at_rest(const RunOptions& options, Report& report);
void defeated(const RunOptions& options, Report& report);
void free_collision(const RunOptions& options, Report& report);
void levers(const RunOptions& options, Report& report);
void determinism(const RunOptions& options, Report& report);

}  // namespace enduring::chapter07
