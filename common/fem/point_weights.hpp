#pragma once

#include "common/fem/elastic_mesh.hpp"
#include "common/fem/surface_embedding.hpp"

#include <vector>

namespace enduring {

/// The shares of nodes in a point of the body, x = sum_i w_i c_i, by the element that holds it at rest; their
/// sum is 1. Empty if the point lies outside of all elements, by more than a millionth of the height of the
/// nearest one.
/// @param point  in the mesh's own coordinates [m]
std::vector<NodeWeight> point_weights(const ElasticMesh& mesh, const Vec3& point);

}  // namespace enduring
