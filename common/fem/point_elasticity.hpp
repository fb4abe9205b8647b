#pragma once

#include "common/fem/elasticity.hpp"
#include "common/fem/material.hpp"

#include <memory>

namespace enduring {

/// Elasticity by a law at each quadrature point: one point in a linear element; the corners and the centroid
/// of a quadratic one, with a rule that is exact for what is quadratic. So each point is strained, and has a
/// frame, by itself.
/// @param law        corotated_at_points or neo_hookean
/// @param mesh       outlives it, as do the rotations
/// @throws InputError  a law that is not taken at points
std::unique_ptr<Elasticity> point_elasticity(ElasticLaw law, const ElasticMesh& mesh,
                                             const LameConstants& lame, const ElementRotations& rotations);

}  // namespace enduring
