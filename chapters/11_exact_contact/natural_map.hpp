#pragma once

#include "chapters/11_exact_contact/friction_problem.hpp"
#include "common/geometry/vector.hpp"

namespace enduring {

/// The nearest point of the cone |r_t| <= mu r_n; a contact's first number is along its normal.
Vec3 nearest_in_cone(const Vec3& impulse, double mu);

/// How far an impulse and a velocity of one contact are from an exact answer: r - P(r - u~), with u~ = u + mu
/// |u_t| on its first number, and P the nearest point of the cone. It is zero if and only if both are exact.
/// G. De Saxce, Z.-Q. Feng: The bipotential method, Mathematical and Computer Modelling 28, 1998.
Vec3 natural_map(const Vec3& impulse, const Vec3& velocity, double mu);

/// The length of all contacts' natural maps over the length of q, as FCLIB measures answers; 1e-8 counts as
/// solved.
/// @param impulses  r
double natural_map_error(const FrictionProblem& problem, const Eigen::VectorXd& impulses);

/// A contact's numbers as three, whatever the problem's dimension.
Vec3 numbers_of(const FrictionProblem& problem, const Eigen::VectorXd& all, int contact);

}  // namespace enduring
