#include "chapters/06_redefinition/experiments/levers.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/rigid_body.hpp"

namespace enduring::chapter06 {
namespace {

std::unique_ptr<Body> block(const std::string& name, SurfaceMesh mesh, const Vec3& place, double turned,
                            double mass, const Vec3& velocity)
{
    const Mat3 rotation = Eigen::AngleAxisd(turned, Vec3::UnitY()).toRotationMatrix();
    for (Vec3& x : mesh.vertices)
        x = rotation * x + place;
    return std::make_unique<RigidBody>(name, mesh, with_mass(mass_properties(mesh, 1000), mass), velocity);
}

Vec3 angular_momentum(const World& world)
{
    return world.bodies[0]->angular_momentum(Vec3::Zero()) + world.bodies[1]->angular_momentum(Vec3::Zero());
}

Vec3 linear_momentum(const World& world)
{
    return world.bodies[0]->linear_momentum() + world.bodies[1]->linear_momentum();
}

//! [levers]
/// Adds what a step's impulses give with each lever: I at p and -I at q, wherever these are at that moment.
void add_levers(const World& world, const Contacts& contacts, LeverCost& cost)
{
    for (const Contact& contact : contacts) {
        const auto momentum_at = [&](double tau) {
            const ContactGeometry at = contact_geometry(world, contact, tau);
            return (at.p - at.q).cross(contact.impulse + contact.friction).eval();
        };
        cost.at_start += momentum_at(0);
        cost.in_middle += momentum_at(0.5);
        cost.at_end += momentum_at(1);
        cost.pushed += (contact.impulse + contact.friction).norm();
    }
}
//! [levers]

}  // namespace

LeverCost cost_of_levers(const FreeSlide& slide, const MakeSolver& make_solver)
{
    World world;
    world.gravity.setZero();
    world.bodies.push_back(block("lower", box({2, 0.2, 1}, {7, 1, 3}), {0, -0.1, 0}, 0, 40, Vec3::Zero()));
    world.bodies.push_back(
        block("upper", box({0.2, 0.2, 0.2}), {-0.3, 0.1 + slide.gap, 0.03}, 0.2, 20, {slide.speed, -0.2, 0}));
    LeverCost cost;
    Solver solver = make_solver({PenaltyMethod::continuous, 20000, slide.friction});
    // First of all: what comes later in this list may resolve pairs that have pushed.
    solver.insert_before("resolve vertices", "levers",
                         [&cost](World& in, Contacts& contacts, double) { add_levers(in, contacts, cost); });
    Contacts contacts;
    const Vec3 before = angular_momentum(world), linear_before = linear_momentum(world);
    for (double time = 0; time < 0.1; time += slide.dt)
        advance(world, contacts, solver, slide.dt);
    cost.measured = angular_momentum(world) - before;
    cost.linear = linear_momentum(world) - linear_before;
    return cost;
}

}  // namespace enduring::chapter06
