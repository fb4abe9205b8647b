#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/09_deep_contacts/inside_pairs.hpp"
#include "common/simulation/contact_parameters.hpp"

namespace enduring {

/// Lets a solver with chapter 6's passes ask the neighbours before it calls a pair hooked.
Solver asking_neighbours(Solver solver);

/// This chapter's solver: chapter 7's, for contacts of any depth. Pairs that look hooked ask their
/// neighbours; what lies in another body without a pair gets one, from where the surfaces cross; no spring
/// that is born at a depth, or handed to another face, brings energy; bodies that ask for it meet themselves. It keeps the trees of one world, so
/// make one for each run.
Solver chapter09_solver(const ContactParameters& parameters);
/// The same with settings of one's own, and another choice of the ways out.
Solver chapter09_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        WaysOut ways = shared_way_out);

}  // namespace enduring
