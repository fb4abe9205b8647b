#pragma once

#include <Eigen/Core>

#include <vector>

namespace enduring {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

/// One contact in a plane: its velocity is u = W r + q. The first number is along the ground, the second away
/// from the ground.
struct OneContact {
    Mat2 W;     ///< response [1/kg], symmetric, positive definite
    Vec2 q;     ///< velocity without an impulse [m/s]
    double mu;  ///< coefficient of friction
};

/// The impulse that stops the contact [N s].
Vec2 stopping(const OneContact& contact);

/// The impulse with which the contact slips to one side and does not leave the ground [N s]. It may pull.
/// @param side  of the slip, 1 or -1
Vec2 slipping(const OneContact& contact, int side);

/// All impulses [N s] that obey Signorini and Coulomb: the contact leaves the ground without an impulse, or
/// stops within the cone, or slips against its friction, on the border of the cone. They are in this order,
/// with the slip to the side 1 before the other. Each impulse appears once.
std::vector<Vec2> exact_answers(const OneContact& contact);

}  // namespace enduring
