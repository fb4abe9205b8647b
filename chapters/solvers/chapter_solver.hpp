#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring::solvers {

/// Those whose contact differs; the last is what a program takes if none is chosen.
constexpr int chapters = 11;
/// The last one with a solver: chapter 12's also has joints.
constexpr int last_chapter = 12;

/// The solver of a chapter by its number, 1 to `last_chapter`.
/// @param settings     from chapter 7 on
/// @throws InputError  there is no such chapter
Solver chapter_solver(int chapter, const ContactParameters& parameters,
                      const ImplicitSettings& settings = {});

}  // namespace enduring::solvers
