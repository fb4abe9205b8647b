#pragma once

#include "common/geometry/meshes.hpp"

#include <optional>
#include <vector>

namespace enduring::chapter02 {

/// A spike (a tetrahedron, its tip first) that passes through a thin plate (two triangles) within one step.
struct Tunnelling {
    std::vector<Vec3> spike_t0, spike_t1, plate;
};
Tunnelling tunnelling();

std::vector<Face> plate_faces();
std::vector<Face> spike_faces();  ///< outwards

/// Edges of one that pass through a face of the other, at one moment (thesis section 4.2).
int discrete_hits(const std::vector<Vec3>& spike, const std::vector<Vec3>& plate);

/// When a vertex of the spike first touches a face of the plate.
std::optional<double> first_touch(const Tunnelling& scene);

}  // namespace enduring::chapter02
