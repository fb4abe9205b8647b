#include "chapters/05_categorisation/category.hpp"
#include "chapters/05_categorisation/solver.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"
#include "live/figures.hpp"

#include <memory>

namespace enduring::live {
namespace {

constexpr double dt = 0.01;

/// The scene that runs.
struct Sliding {
    World world;
    Contacts contacts;
    Solver solver;
    double time = 0;
};

std::unique_ptr<Sliding> sliding;

/// What the page marks a pair with.
double mark_of(const Contact& contact)
{
    if (contact.held())
        return 3;
    return contact.category == ContactCategory::hooked    ? 2
           : contact.category == ContactCategory::regular ? 1
                                                          : 0;
}

}  // namespace

void begin_sliding(int solver, double speed)
{
    sliding = std::make_unique<Sliding>();
    SurfaceMesh floor = plane_grid(8, 2, {12, 3});
    SurfaceTopology topology(static_cast<int>(floor.vertices.size()), floor.faces);
    sliding->world.bodies.push_back(
        std::make_unique<StaticBody>("floor", std::move(topology), std::move(floor.vertices)));
    SurfaceMesh cube = box({1, 1, 1});
    for (Vec3& x : cube.vertices)
        x += Vec3(-3.37, 0.5, 0.11);
    const MassProperties properties = with_mass(mass_properties(cube, 1.0), 20.0);
    sliding->world.bodies.push_back(
        std::make_unique<RigidBody>("cube", cube, properties, Vec3(speed, 0, 0), Vec3::Zero()));
    ContactParameters parameters;
    parameters.stiffness = 5000;
    sliding->solver = solver == 6 ? chapter06_solver(parameters) : chapter05_solver(parameters);
}

Numbers slide_on(int steps)
{
    for (int i = 0; i < steps; ++i, sliding->time += dt)
        advance(sliding->world, sliding->contacts, sliding->solver, dt);
    const Body& cube = *sliding->world.bodies[1];
    Vec3 velocity = Vec3::Zero();
    for (int vertex = 0; vertex < 8; ++vertex)
        velocity += cube.velocity(vertex) / 8;
    Numbers result{sliding->time, velocity.x(), static_cast<double>(sliding->contacts.size())};
    for (const Vec3& x : cube.positions_t0())
        result.insert(result.end(), {x.x(), x.y(), x.z()});
    for (const Contact& contact : sliding->contacts) {
        const Vec3 p = contact_geometry(sliding->world, contact, 0).p;
        result.insert(result.end(), {p.x(), p.y(), p.z(), mark_of(contact)});
    }
    return result;
}

}  // namespace enduring::live
