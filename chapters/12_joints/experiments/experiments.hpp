#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter12 {

void pendulum(const RunOptions& options, Report& report);
void double_pendulum(const RunOptions& options, Report& report);
void top(const RunOptions& options, Report& report);
void linkages(const RunOptions& options, Report& report);
void motor(const RunOptions& options, Report& report);
void chain(const RunOptions& options, Report& report);
void door(const RunOptions& options, Report& report);
void rope(const RunOptions& options, Report& report);
void crane(const RunOptions& options, Report& report);
void walker(const RunOptions& options, Report& report);
void gripper(const RunOptions& options, Report& report);

}  // namespace enduring::chapter12
