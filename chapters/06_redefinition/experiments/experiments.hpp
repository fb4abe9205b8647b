#pragma once

#include "chapters/05_categorisation/solver.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter06 {

/// The two solvers that are compared where the last layer is not enough.
struct Compared {
    int chapter;
    Solver (*make)(const ContactParameters&);
};
inline constexpr Compared last_and_this[]{{5, chapter05_solver}, {6, chapter06_solver}};

/// One artefact of thesis 6.1 in its smallest scene, under the solvers of chapters 5 and 6.
/// @param name  of a motivating scene
void artefact(const std::string& name, const RunOptions& options, Report& report);
void step_by_step(const RunOptions& options, Report& report);
void deep(const RunOptions& options, Report& report);
void sliding(const RunOptions& options, Report& report);
void bar_friction(const RunOptions& options, Report& report);
void mesh_slope(const RunOptions& options, Report& report);
void cost(const RunOptions& options, Report& report);
void bunny_bowl(const RunOptions& options, Report& report);
void turntable(const RunOptions& options, Report& report);
void rolling(const RunOptions& options, Report& report);
void laid_block(const RunOptions& options, Report& report);

}  // namespace enduring::chapter06
