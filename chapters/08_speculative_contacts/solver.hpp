#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/08_speculative_contacts/contact_search.hpp"

#include <functional>
#include <memory>

namespace enduring {

/// Chapter 7's solve on pairs that geometry finds afresh in every step. A scene's stiffness and the constants of its
/// friction model are not used, only its coefficients.
Solver chapter08_solver(const ContactParameters& parameters);
/// The same with settings of one's own; the coefficients of friction are the scene's.
Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings);
/// The same with another search.
Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        const std::shared_ptr<ContactSearch>& search);

/// The pairs of a step, with what those of the last one remember.
/// @param find_more  appends pairs of another kind
void renew_pairs(
    ContactSearch& search, const World& world, double dt, Contacts& contacts,
    const std::function<void(Contacts&)>& find_more = [](Contacts&) {});

/// After an answer that moved a vertex by more than the margin: pairs that it brought inside.
void append_pairs_brought_inside(ContactSearch& search, const World& world, double dt, Contacts& contacts);

}  // namespace enduring
