#pragma once

#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring::solvers {

constexpr int chapters = 11;

/// The solver of a chapter by its number, 1 to `chapters`.
/// @throws InputError  there is no such chapter
Solver chapter_solver(int chapter, const ContactParameters& parameters);

}  // namespace enduring::solvers
