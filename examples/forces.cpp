// A scene without a file: a box slides on a table and stops. Prints the forces of pairs, bodies and the box's
// vertices.
#include "chapters/10_self_contact/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/contact_forces.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/rigid_body.hpp"

#include <cmath>
#include <cstdio>

using namespace enduring;

std::unique_ptr<Body> rigid_box(const char* name, const Vec3& size, const Vec3& place, const Vec3& velocity)
{
    SurfaceMesh mesh = box(size);
    for (Vec3& vertex : mesh.vertices)
        vertex += place;
    return std::make_unique<RigidBody>(name, mesh, mass_properties(mesh, 500), velocity);
}

/// What rounds to zero has no sign.
double without_sign_of_zero(double newtons) { return std::abs(newtons) < 5e-4 ? 0 : newtons; }

int main()
{
    World world;
    world.planes.push_back({"ground"});
    world.bodies.push_back(rigid_box("table", {1, 0.5, 1}, {0, 0.25, 0}, Vec3::Zero()));
    world.bodies.push_back(rigid_box("box", {0.2, 0.2, 0.2}, {-0.2, 0.6, 0}, {1, 0, 0}));
    ContactParameters parameters;
    parameters.friction = MassSplitting{0.4, 0.3};
    const Solver solver = chapter10_solver(parameters);
    Contacts contacts;
    const double dt = 0.005;
    while (world.time < 1)
        advance(world, contacts, solver, dt);

    for (const Contact& contact : contacts) {
        const PairForce force = pair_force(contact, last_part(world, dt));
        std::printf("%s on %s: %.3f N along the normal, %.3f N of friction\n",
                    name_of_b(world, contact).c_str(), name_of_a(world, contact).c_str(), force.normal.norm(),
                    force.friction.norm());
    }
    const std::vector<Vec3> forces = body_forces(world, contacts, dt);
    for (std::size_t b = 0; b < forces.size(); ++b)
        std::printf("%s of %.3f kg: %.3f N up\n", world.bodies[b]->name().c_str(), world.bodies[b]->mass(),
                    forces[b].y());
    for (const std::vector<std::vector<Vec3>> of_bodies = vertex_forces(world, contacts, dt);
         const Vec3& force : of_bodies[1])
        std::printf("box vertex: %.3f %.3f %.3f N\n", without_sign_of_zero(force.x()), force.y(),
                    without_sign_of_zero(force.z()));
}
