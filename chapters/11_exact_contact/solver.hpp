#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Chapter 8's solver with springs that remember their force along the normal from step to step, a part of a pass of the method
/// of multipliers each: what rests is no longer pressed in.
Solver chapter11_solver(const ContactParameters& parameters);
/// The same with settings of one's own; the coefficients of friction are the scene's.
Solver chapter11_solver(const ContactParameters& parameters, ImplicitSettings settings);

/// After each step: a hundredth of how far a spring is pressed moves into its rest offset, so that in the end it holds the same
/// force at no depth. The step takes a tenth of any offset away (StiffnessChoice::keep), so a ninth more is put in. A pair that began
/// inside is left alone until its offset has faded.
/// @param keep  StiffnessChoice::keep of the solver
void remember_forces(Contacts& contacts, double keep, double dt);

}  // namespace enduring
