#pragma once

#include "chapters/02_collision_detection/surface_step.hpp"
#include "common/simulation/step.hpp"

#include <limits>

namespace enduring {

/// What lies under a vertex when the step begins: of the faces that hold its foot, the nearest.
struct Ground {
    double distance = std::numeric_limits<double>::infinity();  ///< [m]
    Vec3 normal = Vec3::Zero();                                 ///< of unit length; zero over no face

    /// Takes a face for the ground where it is nearer.
    void look_at(const SurfaceStep& a, int vertex, const SurfaceStep& b, int face);
};

/// The normal of the path on which a vertex comes along a surface that bends in this step: of the normals from that of
/// the start to as far before it as that of the end lies behind it, the one along which the vertex does not move.
///
/// @param start   unit normal of the surface under the vertex when the step begins
/// @param end     unit normal of the pair at the end of the step
/// @param motion  of the vertex against the surface, as it would be without the forces of this step [m]
/// @return        a unit vector; zero where the surface is flat, or the vertex does not come along it but hits it
Vec3 sliding_normal(const Vec3& start, const Vec3& end, const Vec3& motion);

/// The motion of a pair's points against each other, but for what gravity does in this step [m].
Vec3 motion_without_gravity(const World& world, const Contact& contact, double dt);

}  // namespace enduring
