#pragma once

#include "chapters/02_collision_detection/face_tree.hpp"

#include <array>

namespace enduring {

/// Weights of a triangle's corners; not negative, their sum is 1. On a
/// corner or an edge the others are exactly 0.
using FaceWeights = std::array<double, 3>;

/// The point of a triangle nearest to p.
/// @see Ericson, Real-Time Collision Detection (2005), section 5.1.5
FaceWeights closest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// The point of a surface nearest to a point p.
struct ClosestPoint {
    int face = -1;  ///< -1: no face is nearer than was asked for
    FaceWeights weights{};
    Vec3 point = Vec3::Zero();    ///< [m]
    double squared_distance = 0;  ///< to p [m^2]
};

/// Searches the tree, the nearest boxes first. Where several faces are equally
/// near, which one is found depends on their order alone.
/// @param tree       after a refit to the same positions
/// @param positions  of the surface's vertices [m]
/// @param within     points farther away than this [m] are of no interest
ClosestPoint closest_point(const FaceTree& tree, const SurfaceTopology& surface,
                           std::span<const Vec3> positions, const Vec3& p, double within);

/// The direction that tells at a closest point which side is out: p is inside
/// if and only if pseudonormal . (p - point) < 0.
///
/// On a face it is the face's normal, on an edge the sum of its faces' unit normals, at a corner the sum of
/// its faces' unit normals weighted by their angles there; no other choice is right at every corner. A
/// surface with a border has no inside beyond it: there the direction is zero.
/// @return [1], not normalised
/// @see Baerentzen and Aanaes, Signed distance computation using the angle weighted pseudonormal (2005)
Vec3 pseudonormal(const SurfaceTopology& surface, std::span<const Vec3> positions,
                  const ClosestPoint& closest);

}  // namespace enduring
