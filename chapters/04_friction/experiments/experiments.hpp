#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter04 {

void slope(const RunOptions& options, Report& report);
void printed_constants(const RunOptions& options, Report& report);
void threshold(const RunOptions& options, Report& report);
void tilting(const RunOptions& options, Report& report);
void rocking(const RunOptions& options, Report& report);
void turning(const RunOptions& options, Report& report);
void mesh_slope(const RunOptions& options, Report& report);

}  // namespace enduring::chapter04
