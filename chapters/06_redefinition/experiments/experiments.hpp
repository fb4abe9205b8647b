#pragma once

#include "common/report/chapter_program.hpp"

namespace enduring::chapter06 {

void sliding(const RunOptions& options, Report& report);

/// Where this chapter's gnuplot scripts lie.
std::filesystem::path plot_script(const std::string& name);

}  // namespace enduring::chapter06
