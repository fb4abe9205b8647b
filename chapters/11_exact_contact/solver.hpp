#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/11_exact_contact/exact_step.hpp"
#include "common/simulation/contact_parameters.hpp"

namespace enduring {

/// Chapter 10's solver, whose solve is repeated: each spring begins a pass with the force that it had in the
/// last one, until depth and slip of what pushes and holds are gone. It keeps the trees of one world, so make
/// one for each run.
Solver chapter11_solver(const ContactParameters& parameters);
/// The same with settings of one's own; the coefficients of friction are the scene's.
Solver chapter11_solver(const ContactParameters& parameters, ImplicitSettings settings);
Solver chapter11_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        ExactStepSettings exact);

}  // namespace enduring
