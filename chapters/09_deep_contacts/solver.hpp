#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/09_deep_contacts/inside_pairs.hpp"
#include "common/simulation/contact_parameters.hpp"

namespace enduring {

/// This chapter's solver: chapter 8's, for contacts of any depth. What lies in another body without a pair gets one,
/// from where the surfaces cross; no spring that begins at a depth brings energy; bodies that ask for it meet
/// themselves. It keeps the trees of one world, so make one for each run.
Solver chapter09_solver(const ContactParameters& parameters);
/// The same with settings of one's own, and another choice of the ways out.
Solver chapter09_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        SeparationMethod method = overlap_direction);

}  // namespace enduring
