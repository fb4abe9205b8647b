#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"

namespace enduring {

/// This chapter's solver: chapter 6's pairs, answered together by the motion that their answers make. A
/// scene's stiffness and the constants of its friction model are not used, only its coefficients.
Solver chapter07_solver(const ContactParameters& parameters);
/// The same with settings of one's own; the coefficients of friction are the scene's.
Solver chapter07_solver(const ContactParameters& parameters, ImplicitSettings settings);

}  // namespace enduring
