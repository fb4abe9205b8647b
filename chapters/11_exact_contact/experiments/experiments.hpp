#pragma once

#include "common/experiments/report/chapter_program.hpp"
#include "common/scenes/scene.hpp"

#include <filesystem>

namespace enduring::chapter11 {

void spring_error(const RunOptions& options, Report& report);
/// @param more  a folder of the reader's; nothing if empty
void scoreboard(const RunOptions& options, Report& report, const std::filesystem::path& more);
/// @param more  as above
/// @param set   of generated_problems(): those on which the solver was not tried
void score_sets(const RunOptions& options, Report& report, const std::filesystem::path& more, unsigned set);
void own_problems(const RunOptions& options, Report& report);
/// @param set  of generated_problems()
void generated(const RunOptions& options, Report& report, unsigned set);
void stack_exact(const RunOptions& options, Report& report);
void exact_scenes(const RunOptions& options, Report& report);
void relaxation(const RunOptions& options, Report& report);

/// A thin plate of 1 kg and 2 m that leans over its lower edge and slides on it with 1 m/s in the direction
/// in which it leans: the rod as a body of a scene.
/// @param angle  of the rod against the ground [rad]
Scene rod_scene(double angle, double mu, double dt);

}  // namespace enduring::chapter11
