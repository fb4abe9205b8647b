#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "common/simulation/contact_parameters.hpp"

namespace enduring {

/// Settings with what a scene asks for: its coefficients of friction, and its depth.
ImplicitSettings settings_for(const ContactParameters& parameters, ImplicitSettings settings);

/// Gives a solver that finds pairs this chapter's solve of them.
void add_solve(Solver& solver, const ImplicitSettings& settings);

}  // namespace enduring
