#pragma once

#include "common/geometry/meshes.hpp"
#include "common/simulation/step.hpp"

#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleInfoMap.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>

#include <memory>
#include <span>

namespace enduring::bullet {

/// Distance from the origin to the nearest plane of a face [m]: the radius of
/// the largest ball about the origin in a convex body, negative if the origin lies outside.
double inner_radius(std::span<const Vec3> points, std::span<const Face> faces);

/// Whether a surface is the closed surface of a convex body: no point lies in front of a face.
bool is_convex(std::span<const Vec3> points, const SurfaceTopology& surface);

/// Bullet's margin for a body of some inner radius: its 4 cm, or a tenth of the radius for small bodies, as
/// its manual asks ("use smaller margins for small objects").
double collision_margin(double inner_radius);

/// A convex body. Bullet adds its margin around a hull, so the hull is shrunk by it first: then the faces lie
/// where they should, and corners are round.
/// @param points  with the origin inside [m]
std::unique_ptr<btCollisionShape> hull_shape(std::span<const Vec3> points, std::span<const Face> faces);

/// A surface as Bullet keeps it; the shape refers to the triangles, and to what is known of their edges.
struct TriangleShape {
    btTriangleMesh triangles;
    btTriangleInfoMap edges;
    std::unique_ptr<btCollisionShape> shape;
};

/// A surface that stays where it is, without a margin of its own: the other body has one. Bullet is told
/// which of its edges lie inside a flat side, so that bodies that slide over them are not pushed along it.
std::unique_ptr<TriangleShape> static_triangles(std::span<const Vec3> points, std::span<const Face> faces);

/// A surface of any form that moves.
std::unique_ptr<TriangleShape> moving_triangles(std::span<const Vec3> points, std::span<const Face> faces);

/// The half space below a plane through the origin.
std::unique_ptr<btCollisionShape> half_space(const Vec3& normal);
/// A box of 100 m whose upper side, turned to y, lies at the origin: what a plane is for Bullet's soft
/// bodies, which meet convex shapes only.
std::unique_ptr<btCollisionShape> large_box();
constexpr double large_box_size = 100;  ///< [m]

}  // namespace enduring::bullet
