#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"

namespace enduring {

/// This chapter's solver: chapter 9's with another search. Bodies that ask for it meet themselves. It keeps
/// the trees of one world, so make one for each run.
Solver chapter10_solver(const ContactParameters& parameters);
/// The same with settings of one's own.
Solver chapter10_solver(const ContactParameters& parameters, ImplicitSettings settings);

}  // namespace enduring
