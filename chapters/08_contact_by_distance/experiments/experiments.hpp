#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter08 {

void heap(const RunOptions& options, Report& report);
void families(const RunOptions& options, Report& report);
void ridges(const RunOptions& options, Report& report);
void fast(const RunOptions& options, Report& report);
void edge_on_edge(const RunOptions& options, Report& report);
void at_rest(const RunOptions& options, Report& report);
void wedged(const RunOptions& options, Report& report);
void creep(const RunOptions& options, Report& report);
void wanted_depth(const RunOptions& options, Report& report);
void rolling(const RunOptions& options, Report& report);
void facets(const RunOptions& options, Report& report);
void flat_triangles(const RunOptions& options, Report& report);
void frictionless(const RunOptions& options, Report& report);
void screw(const RunOptions& options, Report& report);
void tops(const RunOptions& options, Report& report);
void soft_piles(const RunOptions& options, Report& report);
void soft_contact(const RunOptions& options, Report& report);
void turntable(const RunOptions& options, Report& report);
void spinning(const RunOptions& options, Report& report);
void launch(const RunOptions& options, Report& report);
void driven(const RunOptions& options, Report& report);
void pressed(const RunOptions& options, Report& report);
void bouncing(const RunOptions& options, Report& report);
void spheres(const RunOptions& options, Report& report);
void disk(const RunOptions& options, Report& report);
void limits(const RunOptions& options, Report& report);
void gears(const RunOptions& options, Report& report);
void formulas(const RunOptions& options, Report& report);
void forces(const RunOptions& options, Report& report);
void harsh(const RunOptions& options, Report& report);
void jams(const RunOptions& options, Report& report);
void gaps(const RunOptions& options, Report& report);
void crossings(const RunOptions& options, Report& report);
void constants(const RunOptions& options, Report& report);

}  // namespace enduring::chapter08
