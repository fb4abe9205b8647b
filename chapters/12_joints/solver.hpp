#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// This chapter's solver: chapter 10's, which holds the world's joints as well.
Solver chapter12_solver(const ContactParameters& parameters);
/// The same with settings of one's own; the coefficients of friction are the scene's.
Solver chapter12_solver(const ContactParameters& parameters, ImplicitSettings settings);

}  // namespace enduring
