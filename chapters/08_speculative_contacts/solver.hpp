#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "common/simulation/contact_parameters.hpp"

namespace enduring {

/// This chapter's solver. So far it is chapter 7's, whose pairs are found where features pass each other and
/// followed from then on; pairs that geometry tells afresh in each step take their place here.
Solver chapter08_solver(const ContactParameters& parameters);
/// The same with settings of one's own; the coefficients of friction are the scene's.
Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings);

}  // namespace enduring
