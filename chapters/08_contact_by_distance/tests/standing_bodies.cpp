#include "chapters/08_contact_by_distance/standing_bodies.hpp"

#include "chapters/08_contact_by_distance/tests/small_world.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/whole_motion.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::distance_tests;

namespace {

Vec3 momentum_of(const World& world)
{
    Vec3 sum = Vec3::Zero();
    for (const auto& body : world.bodies)
        sum += body->linear_momentum();
    return sum;
}

Vec3 spin_of(const World& world)
{
    Vec3 sum = Vec3::Zero();
    for (const auto& body : world.bodies)
        sum += body->angular_momentum(Vec3::Zero());
    return sum;
}

Vec3 turn_of(const Body& body)
{
    const WholeMotion whole = whole_motion(body).value();
    return whole.inertia.inverse() * whole.spin;
}

/// Two rigid bodies and a soft one, which all move and turn.
World three_bodies()
{
    World world;
    world.gravity.setZero();
    add_rigid(world, moved(box({0.5, 0.1, 0.3}), {5, 1, 0}), {1, -2, 0}, {0, 3, 1});
    add_rigid(world, moved(sphere(0.1, 1), {5, 1.2, 0.1}), {0, -200, 0}, {30, 0, 50});
    DeformableSettings settings;
    settings.material = {1e5, 0.3, 1000};
    settings.position = {5.4, 1.1, 0};
    settings.velocity = {-3, 0, 0};
    settings.angular_velocity = {0, 7, 0};
    world.bodies.push_back(
        std::make_unique<DeformableBody>("soft", bar({0.2, 0.1, 0.2}, {2, 1, 2}), settings));
    return world;
}

void move(World& world, double dt)
{
    for (const auto& body : world.bodies) {
        body->predict(world.gravity, dt);
        body->commit(dt);
    }
}

}  // namespace

TEST_CASE("standing bodies: what would cross stays where it is, and moves on as one with its momentum")
{
    World world = three_bodies();
    const Vec3 momentum = momentum_of(world), spin = spin_of(world);
    const double energy = total_energy(world).total();
    std::vector<Vec3> places;
    for (const auto& body : world.bodies)
        places.push_back(body->positions_t0()[0]);

    StandingBodies standing;
    CHECK(standing.add(world, 0, 1));
    CHECK(standing.add(world, 2, 1));
    CHECK(!standing.add(world, 2, 0));
    move(world, 1e-3);
    standing.move_on(world);

    CHECK((momentum_of(world) - momentum).norm() < 1e-12 * momentum.norm());
    CHECK((spin_of(world) - spin).norm() < 1e-9 * spin.norm());
    CHECK(total_energy(world).total() < energy);
    const WholeMotion first = whole_motion(*world.bodies[0]).value();
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const WholeMotion whole = whole_motion(*world.bodies[i]).value();
        const Vec3 turn = turn_of(*world.bodies[0]),
                   velocity = first.momentum / first.mass + turn.cross(whole.centre - first.centre);
        CHECK(world.bodies[i]->positions_t0()[0] == places[i]);
        CHECK((turn_of(*world.bodies[i]) - turn).norm() < 1e-9 * turn.norm());
        CHECK((whole.momentum / whole.mass - velocity).norm() < 1e-9 * velocity.norm());
    }
}

TEST_CASE("standing bodies: a rigid body that would cross a fixed one is at rest, and so who would cross it")
{
    World world = three_bodies();
    add_static(world, box({1, 1, 1}));
    StandingBodies standing;
    standing.add(world, 0, 3);
    standing.add(world, 1, 0);
    const Vec3 of_soft = world.bodies[2]->linear_momentum();
    move(world, 1e-3);
    standing.move_on(world);
    CHECK(world.bodies[0]->linear_momentum() == Vec3(Vec3::Zero()));
    CHECK(world.bodies[1]->linear_momentum() == Vec3(Vec3::Zero()));
    CHECK((world.bodies[2]->linear_momentum() - of_soft).norm() < 1e-9 * of_soft.norm());
}

TEST_CASE("standing bodies: of two groups each keeps its own momentum")
{
    World world = three_bodies();
    add_rigid(world, moved(sphere(0.1, 1), {9, 1.2, 0.1}), {0, 5, 0}, {3, 0, 5});
    StandingBodies standing;
    standing.add(world, 0, 1);
    standing.add(world, 2, 3);
    const Vec3 before = world.bodies[0]->linear_momentum() + world.bodies[1]->linear_momentum();
    move(world, 1e-3);
    standing.move_on(world);
    const Vec3 after = world.bodies[0]->linear_momentum() + world.bodies[1]->linear_momentum();
    CHECK((after - before).norm() < 1e-12 * before.norm());
    CHECK(world.bodies[3]->mean_velocity().x() < -0.1);
}
