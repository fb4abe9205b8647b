#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/09_deep_contacts/deep_search.hpp"

#include <memory>

namespace enduring {

/// This chapter's solver: chapter 8's, with a search for contacts of any depth. What overlaps gets pairs from
/// where the surfaces cross; no spring that begins at a depth brings energy. It keeps the trees of one world,
/// so make one for each run.
Solver chapter09_solver(const ContactParameters& parameters);
/// The same with settings of one's own, and another search.
Solver chapter09_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        const std::shared_ptr<DeepSearch>& search = std::make_shared<DeepSearch>());

}  // namespace enduring
