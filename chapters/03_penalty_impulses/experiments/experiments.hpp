#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter03 {

void impulse_shape(const RunOptions& options, Report& report);
void normalisation(const RunOptions& options, Report& report);
void bar_on_cube(const RunOptions& options, Report& report);
void penetration(const RunOptions& options, Report& report);
void hooked(const RunOptions& options, Report& report);
/// @param elements  of the bunny: 363, 785, 1452 or 10668
void bunny_bowl(const RunOptions& options, Report& report, int elements);

}  // namespace enduring::chapter03
