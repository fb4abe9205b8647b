#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "common/simulation/contact_parameters.hpp"

namespace enduring {

/// Lets a solver with chapter 6's passes ask the neighbours before it calls a pair hooked.
Solver asking_neighbours(Solver solver);

/// This chapter's solver: chapter 7's, and pairs that look hooked ask their neighbours.
Solver chapter08_solver(const ContactParameters& parameters);

}  // namespace enduring
