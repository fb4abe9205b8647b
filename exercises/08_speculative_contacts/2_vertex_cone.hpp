#pragma once

#include "common/geometry/meshes.hpp"

#include <optional>
#include <vector>

namespace enduring {

/// The vertices that share a face with a vertex, each once, ascending.
std::vector<int> neighbours_of(const SurfaceMesh& mesh, int vertex);

/// Sine of the largest angle by which a neighbour stands before the plane through the vertex, at right angles to the
/// direction: negative if all are behind it.
/// @param direction  unit length
double worst_sine(const SurfaceMesh& mesh, int vertex, const Vec3& direction);

/// Whether a plane can touch the surface in this vertex: no neighbour passes it by more than the sine, and some face at
/// the vertex looks that way.
bool in_cone(const SurfaceMesh& mesh, int vertex, const Vec3& direction, double sine);

/// A direction of unit length that is in the cone of the vertex, with a sine of 1e-9; none if there is none. If the
/// cone is a solid angle or part of a plane, take one of its borders.
std::optional<Vec3> direction_in_cone(const SurfaceMesh& mesh, int vertex);

}  // namespace enduring
