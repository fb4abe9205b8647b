#pragma once

#include "chapters/11_exact_contact/spring_pass.hpp"

namespace enduring {

/// Newton's step of a pass: the change of r for which the straightened equation holds. What a contact that
/// does not push changes is known, so only those that push are unknown. Their matrix is factored dense or
/// sparse, as W is.
/// @param wish   what the springs wish at r
/// @param error  of the equation at r
/// @return       not finite where the matrix is singular
Eigen::VectorXd newton_direction(const SpringPass& pass, double rho, const Eigen::VectorXd& wish,
                                 const Eigen::VectorXd& error);

}  // namespace enduring
