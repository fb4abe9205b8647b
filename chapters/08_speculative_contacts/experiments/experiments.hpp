#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter08 {

void heap(const RunOptions& options, Report& report);

}  // namespace enduring::chapter08
