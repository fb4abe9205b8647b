#pragma once

#include "common/report/chapter_program.hpp"

namespace enduring::chapter05 {

void spans(const RunOptions& options, Report& report);
void edge_rule(const RunOptions& options, Report& report);
void ambiguity(const RunOptions& options, Report& report);
void sliding_categories(const RunOptions& options, Report& report);
void dropping(const RunOptions& options, Report& report);

/// Where this chapter's gnuplot scripts lie.
std::filesystem::path plot_script(const std::string& name);

}  // namespace enduring::chapter05
