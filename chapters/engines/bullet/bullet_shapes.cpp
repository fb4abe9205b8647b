#include "chapters/engines/bullet/bullet_shapes.hpp"

#include "chapters/engines/bullet/bullet_vectors.hpp"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <limits>

namespace enduring::bullet {
namespace {

struct FacePlane {
    Vec3 point, normal;
};

FacePlane plane_of(std::span<const Vec3> points, const Face& face)
{
    const auto corner = [&](int i) {
        return points[static_cast<std::size_t>(face[static_cast<std::size_t>(i)])];
    };
    return {corner(0), (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized()};
}

void add(btTriangleMesh& triangles, std::span<const Vec3> points, std::span<const Face> faces)
{
    for (const auto& [a, b, c] : faces) {
        const auto corner = [&](int i) { return to_bullet(points[static_cast<std::size_t>(i)]); };
        triangles.addTriangle(corner(a), corner(b), corner(c));
    }
}

}  // namespace

double inner_radius(std::span<const Vec3> points, std::span<const Face> faces)
{
    double radius = std::numeric_limits<double>::infinity();
    for (const Face& face : faces) {
        const FacePlane plane = plane_of(points, face);
        radius = std::min(radius, plane.normal.dot(plane.point));
    }
    return radius;
}

bool is_convex(std::span<const Vec3> points, const SurfaceTopology& surface)
{
    constexpr double rounding = 1e-9;  // of the body's size
    double size = 0;
    for (const Vec3& x : points)
        size = std::max(size, (x - points.front()).norm());
    return surface.is_closed() &&
           std::all_of(surface.faces().begin(), surface.faces().end(), [&](const Face& face) {
               const FacePlane plane = plane_of(points, face);
               return std::all_of(points.begin(), points.end(), [&](const Vec3& x) {
                   return plane.normal.dot(x - plane.point) <= rounding * size;
               });
           });
}

double collision_margin(double inner_radius) { return std::min(0.04, 0.1 * inner_radius); }

std::unique_ptr<btCollisionShape> hull_shape(std::span<const Vec3> points, std::span<const Face> faces)
{
    const double margin = collision_margin(inner_radius(points, faces));
    btConvexHullComputer hull;
    hull.compute(points.front().data(), static_cast<int>(sizeof(Vec3)), static_cast<int>(points.size()),
                 margin, 0);
    auto shape = std::make_unique<btConvexHullShape>();
    for (int i = 0; i < hull.vertices.size(); ++i)
        shape->addPoint(hull.vertices[i], false);
    shape->setMargin(margin);  // finds the bounds anew
    shape->recalcLocalAabb();
    return shape;
}

std::unique_ptr<TriangleShape> static_triangles(std::span<const Vec3> points, std::span<const Face> faces)
{
    auto kept = std::make_unique<TriangleShape>();
    add(kept->triangles, points, faces);
    auto shape = std::make_unique<btBvhTriangleMeshShape>(&kept->triangles, true);
    shape->setMargin(0);
    btGenerateInternalEdgeInfo(shape.get(), &kept->edges);
    kept->shape = std::move(shape);
    return kept;
}

std::unique_ptr<TriangleShape> moving_triangles(std::span<const Vec3> points, std::span<const Face> faces)
{
    auto kept = std::make_unique<TriangleShape>();
    add(kept->triangles, points, faces);
    auto shape = std::make_unique<btGImpactMeshShape>(&kept->triangles);
    shape->setMargin(0.01);
    shape->updateBound();
    kept->shape = std::move(shape);
    return kept;
}

std::unique_ptr<btCollisionShape> half_space(const Vec3& normal)
{
    auto shape = std::make_unique<btStaticPlaneShape>(to_bullet(normal), 0);
    shape->setMargin(0);
    return shape;
}

std::unique_ptr<btCollisionShape> large_box()
{
    return std::make_unique<btBoxShape>(0.5 * large_box_size * btVector3(1, 1, 1));
}

}  // namespace enduring::bullet
