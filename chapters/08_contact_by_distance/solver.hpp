#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/08_contact_by_distance/distance_search.hpp"

#include <memory>

namespace enduring {

/// Chapter 7's solve on pairs that geometry finds afresh in every step, and that let nothing cross. A scene's
/// stiffness and the constants of its friction model are not used, only its coefficients. It keeps the skins
/// of one world, so make one for each run.
/// @throws InputError  in the first step, if two bodies begin inside each other
Solver chapter08_solver(const ContactParameters& parameters);
/// The same with settings of one's own; the coefficients of friction are the scene's.
Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings);
/// The same with another search.
Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        const std::shared_ptr<DistanceSearch>& search);

}  // namespace enduring
