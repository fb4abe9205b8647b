#pragma once

#include "common/geometry/vector.hpp"

#include <vector>

namespace enduring {

/// Some nodes of a surface around a contact.
struct Patch {
    std::vector<Vec3> positions;   ///< [m]
    std::vector<double> masses;    ///< of each node [kg], positive
    std::vector<Vec3> velocities;  ///< [m/s]
};

/// The parts of an impulse at p that the nodes receive: of all weights with sum 1 whose mean position is p,
/// those that move the patch by a velocity field that is affine in the position.
/// @param p  [m], within the plane of the nodes, or anywhere if they do not lie in one
std::vector<double> spread_weights(const Patch& patch, const Vec3& p);

/// Gives each node its part of an impulse [N s].
void push_patch(Patch& patch, const std::vector<double>& weights, const Vec3& impulse);

/// The mass that the contact feels [kg]: an impulse over the change it
/// makes in the velocity of the weighted point.
double effective_mass(const Patch& patch, const std::vector<double>& weights);

/// The longest stable step [s] of chapter 1's continuous penalty, k dt^2
/// < 2 m, for a contact of stiffness k [N/m].
double longest_step(const Patch& patch, const std::vector<double>& weights, double k);

}  // namespace enduring
