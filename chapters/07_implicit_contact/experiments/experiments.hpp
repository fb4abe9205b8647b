#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter07 {

void implicit_map(const RunOptions& options, Report& report);
void ring(const RunOptions& options, Report& report);
void free_bounce(const RunOptions& options, Report& report);
void stack(const RunOptions& options, Report& report);
void scales(const RunOptions& options, Report& report);
void edge_on_edge(const RunOptions& options, Report& report);
void slope(const RunOptions& options, Report& report);
void rolling(const RunOptions& options, Report& report);
void heap(const RunOptions& options, Report& report);
void at_rest(const RunOptions& options, Report& report);
void soft_at_rest(const RunOptions& options, Report& report);
void wedged(const RunOptions& options, Report& report);
void creep(const RunOptions& options, Report& report);
void wanted_depth(const RunOptions& options, Report& report);
void flat_triangles(const RunOptions& options, Report& report);
void frictionless(const RunOptions& options, Report& report);
void screw(const RunOptions& options, Report& report);
void turntable(const RunOptions& options, Report& report);
void free_collision(const RunOptions& options, Report& report);
void spinning(const RunOptions& options, Report& report);
void same_bytes(const RunOptions& options, Report& report);
void launch(const RunOptions& options, Report& report);
void facets(const RunOptions& options, Report& report);

}  // namespace enduring::chapter07
