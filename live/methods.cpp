#include "chapters/11_exact_contact/solver.hpp"
#include "chapters/13_other_solvers/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "live/figures.hpp"

#include <memory>

namespace enduring::live {
namespace {

constexpr double dt = 0.01;
constexpr int steps = 10;

/// Where a cube of 10 kg and 1 m is that slides over the ground, from where it began [m].
Vec3 way_of(const Solver& solver, double speed)
{
    World world;
    world.gravity = Vec3(0, -9.81, 0);
    world.planes.push_back({"ground"});
    SurfaceMesh cube = box({1, 1, 1});
    for (Vec3& x : cube.vertices)
        x += Vec3(0, 0.5, 0);
    const MassProperties properties = with_mass(mass_properties(cube, 1.0), 10.0);
    world.bodies.push_back(
        std::make_unique<RigidBody>("cube", cube, properties, Vec3(speed, 0, 0), Vec3::Zero()));
    const Vec3 from = world.bodies[0]->centre();
    Contacts contacts;
    for (int step = 0; step < steps; ++step)
        advance(world, contacts, solver, dt);
    return world.bodies[0]->centre() - from;
}

}  // namespace

std::vector<std::string> method_titles()
{
    std::vector<std::string> titles;
    for (const OtherMethod& method : other_methods())
        titles.push_back(method.title);
    return titles;
}

Numbers methods(double mu, double speed, int counts)
{
    ContactParameters contact;
    contact.friction = MassSplitting{.mu_s = mu, .mu_d = mu};
    const Vec3 exact = way_of(chapter11_solver(contact), speed);
    Numbers result{exact.x()};
    for (const OtherMethod& method : other_methods())
        for (int i = 0; i < counts; ++i) {
            const Vec3 off = way_of(method.make_with(contact, 1 << i), speed) - exact;
            result.insert(result.end(), {off.x(), off.y()});
        }
    return result;
}

}  // namespace enduring::live
