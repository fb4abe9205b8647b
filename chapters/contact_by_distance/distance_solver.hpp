#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"

namespace enduring {

/// Chapter 7's solve on surfaces that never cross: contact by distance.
/// @param own_surfaces  whether a soft body meets itself
Solver distance_solver(const ContactParameters& parameters, ImplicitSettings settings = {},
                       bool own_surfaces = false);

}  // namespace enduring
