#pragma once

#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/winding_number.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <memory>

namespace enduring::distance_tests {

inline void add_static(World& world, const SurfaceMesh& mesh)
{
    world.bodies.push_back(std::make_unique<StaticBody>(
        "fixed", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
}

inline RigidBody& add_rigid(World& world, const SurfaceMesh& mesh, const Vec3& velocity = Vec3::Zero(),
                            const Vec3& spin = Vec3::Zero())
{
    auto body = std::make_unique<RigidBody>("body", mesh, mass_properties(mesh, 1000), velocity, spin);
    RigidBody& added = *body;
    world.bodies.push_back(std::move(body));
    return added;
}

/// Whether a vertex of one body is inside another one, of their surfaces for contact; of closed bodies, by
/// the winding number, which no search knows.
inline bool any_inside(const World& world)
{
    for (const auto& a : world.bodies)
        for (const auto& b : world.bodies)
            for (const Vec3& p : a->contact_t0())
                if (a != b && winding_number(b->surface().faces(), b->contact_t0(), p) > 0.5)
                    return true;
    return false;
}

/// Runs a world and counts the steps after which something is inside.
struct Run {
    int crossed = 0;
    double pushed = 0;  ///< sum of all impulses [N s]

    Run(World& world, int steps, double dt, double friction = 0.5)
    {
        ContactParameters parameters;
        parameters.friction = MassSplitting{friction, friction};
        const Solver solver = chapter08_solver(parameters);
        Contacts contacts;
        for (int i = 0; i < steps; ++i) {
            advance(world, contacts, solver, dt);
            crossed += any_inside(world);
            for (const Contact& contact : contacts)
                pushed += contact.impulse.norm() + contact.friction.norm();
        }
    }
};

}  // namespace enduring::distance_tests
