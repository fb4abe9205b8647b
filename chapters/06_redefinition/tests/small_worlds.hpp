#pragma once

#include "chapters/06_redefinition/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/point_masses.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <memory>

namespace enduring::small_worlds {

inline std::unique_ptr<Body> still(const std::string& name, const SurfaceMesh& mesh)
{
    return std::make_unique<StaticBody>(
        name, SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices);
}

/// A wide, flat cone that points down: the surface around vertex 0, its tip,
/// looks down on all sides, and all else is high up.
inline std::unique_ptr<Body> tip(const Vec3& place, const Vec3& velocity)
{
    const std::vector<Vec3> points{place, place + Vec3(4, 1, 0), place + Vec3(-2, 1, 3.5),
                                   place + Vec3(-2, 1, -3.5)};
    return std::make_unique<PointMasses>("tip", points, std::vector<Face>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}, 1,
                                         velocity);
}

/// Body 0 is a still surface, body 1 a tip; no gravity.
inline World tip_and(const SurfaceMesh& surface, const Vec3& place, const Vec3& velocity = Vec3::Zero())
{
    World world;
    world.gravity.setZero();
    world.bodies.push_back(still("surface", surface));
    world.bodies.push_back(tip(place, velocity));
    return world;
}

inline Vec3 tip_place(const World& world) { return world.bodies[1]->positions_t0()[0]; }

/// Sends every point of a body another way.
inline void turn_to(World& world, const Vec3& velocity)
{
    PointMasses& body = dynamic_cast<PointMasses&>(*world.bodies[1]);
    for (int vertex = 0; vertex < body.surface().vertex_count(); ++vertex)
        body.set_velocity(vertex, velocity);
}

/// The pair of the tip and a face, as an earlier step left it.
inline Contact on_face(const World& world, int face)
{
    const Face& f = world.bodies[0]->surface().faces()[face];
    return {ContactKind::vertex_face,         1, 0, 0, face, {0, f[0], f[1], f[2]},
            {1, -1 / 3.0, -1 / 3.0, -1 / 3.0}};
}

/// The tip's pairs with faces.
inline Contacts of_tip(const Contacts& contacts)
{
    Contacts some;
    for (const Contact& contact : contacts)
        if (contact.kind == ContactKind::vertex_face && contact.body_a == 1 && contact.feature_a == 0)
            some.push_back(contact);
    return some;
}

inline Solver weak_solver(double stiffness = 1e-9)
{
    return chapter06_solver({PenaltyMethod::continuous, stiffness});
}

}  // namespace enduring::small_worlds
