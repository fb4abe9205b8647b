#pragma once

#include "common/experiments/report/chapter_program.hpp"

#include <filesystem>

namespace enduring::chapter11 {

void spring_error(const RunOptions& options, Report& report);
/// @param more  a folder of the reader's; nothing if empty
void scoreboard(const RunOptions& options, Report& report, const std::filesystem::path& more);
void own_problems(const RunOptions& options, Report& report);
void stack_exact(const RunOptions& options, Report& report);
void exact_scenes(const RunOptions& options, Report& report);
void relaxation(const RunOptions& options, Report& report);

}  // namespace enduring::chapter11
