#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::solvers {

void passes(const RunOptions& options, Report& report);
void ledger(const RunOptions& options, Report& report);
void forces(const RunOptions& options, Report& report);
void speed(const RunOptions& options, Report& report);
/// A part of speed(): the matrix of Newton's method, its operations as estimated and the time of its factor.
void speed_of_matrices(bool quick, Report& report);
/// Mats of soft elements lying flat, with a dense block each and with all their nodes.
void soft_speed(const RunOptions& options, Report& report);
/// Walls that are hit, spheres that are poured, a chain that sags and one at rest: the mean and the worst
/// step.
void worst(const RunOptions& options, Report& report);
/// More and more bodies or elements: the time of a step with one thread and with two.
void sizes(const RunOptions& options, Report& report);
/// The example of the page on scenes, run as a scene of the reader's own: its results go to the folder
/// tumble, and the picture to the program's as well.
void own_scene_example(const RunOptions& options, Report& report);

}  // namespace enduring::solvers
