#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/08_speculative_contacts/contact_search.hpp"

#include <memory>

namespace enduring {

/// This chapter's solver: chapter 8's, for contacts of any depth. What lies in another body without a pair gets one,
/// from where the surfaces cross; no spring that begins at a depth brings energy. It keeps the trees of one world, so
/// make one for each run.
Solver chapter09_solver(const ContactParameters& parameters);
/// The same with settings of one's own, and another search.
Solver chapter09_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        const std::shared_ptr<ContactSearch>& search = std::make_shared<ContactSearch>());

}  // namespace enduring
