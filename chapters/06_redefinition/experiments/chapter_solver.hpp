#pragma once

#include "common/scenes/scene.hpp"

namespace enduring::chapter06 {

/// The solver of a chapter by its number.
/// @throws InputError  a chapter without a solver of its own
Solver chapter_solver(int chapter, const ContactParameters& parameters);

}  // namespace enduring::chapter06
