#pragma once

#include "chapters/07_implicit_contact/contact_problem.hpp"
#include "chapters/11_exact_contact/friction_problem.hpp"

namespace enduring {

/// Part of W's mean diagonal that is added to its diagonal where W alone is given: A is its inverse, and W has none where there
/// are more contacts than ways to move. The passes of force_memory.hpp take the error away again. A ten-thousandth: Newton's
/// method stalls at the rounding of A. A hundred times: more passes.
inline constexpr double response_shift = 1e-6;

/// The same problem with springs in place of rigid contact: chapter 7's, at rest where nothing acts, for a step of 1 s. Its
/// coordinates are those of the bodies where they are given and each contact moves few enough of them; else they are the
/// contacts' velocities, and A the inverse of W. A contact's normal is the first axis.
/// @param h  k dt^2 / m of each contact, m the mass that it feels along its normal
ContactProblem springs_of(const FrictionProblem& problem, double h);

}  // namespace enduring
