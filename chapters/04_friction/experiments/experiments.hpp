#pragma once

#include "common/report/chapter_program.hpp"

namespace enduring::chapter04 {

void slope(const RunOptions& options, Report& report);
void printed_constants(const RunOptions& options, Report& report);
void threshold(const RunOptions& options, Report& report);
void tilting(const RunOptions& options, Report& report);
void rocking(const RunOptions& options, Report& report);
void turning(const RunOptions& options, Report& report);
void mesh_slope(const RunOptions& options, Report& report);

/// Where this chapter's gnuplot scripts lie.
std::filesystem::path plot_script(const std::string& name);

}  // namespace enduring::chapter04
