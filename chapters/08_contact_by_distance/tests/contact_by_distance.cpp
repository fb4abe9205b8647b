#include "chapters/08_contact_by_distance/tests/small_world.hpp"
#include "common/geometry/moved_mesh.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;
using namespace enduring::distance_tests;

TEST_CASE("contact by distance: two boxes 0.4 mm apart that fall together feel nothing, at any step")
{
    for (const double dt : {0.001, 0.01, 0.04}) {
        CAPTURE(dt);
        World world;
        const Quaternion turn(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()));
        add_rigid(world, placed(box({0.1, 0.1, 0.1}), turn, turn * Vec3(0, 0, 0)));
        const RigidBody& upper = add_rigid(world,
                                           placed(box({0.1, 0.1, 0.1}), turn, turn * Vec3(0, 0.1004, 0)));
        const double start = upper.motion().centre().y();
        const Run run(world, 10, dt);
        CHECK(run.pushed == 0);
        const double time = 10 * dt;  // a step's fall is that of its end speed
        CHECK(upper.motion().centre().y() - start ==
              doctest::Approx(-0.5 * 9.81 * time * (time + dt)).epsilon(1e-9));
    }
}

TEST_CASE("contact by distance: boxes that begin in exact touch stay where they are")
{
    World world;
    add_static(world, moved(box({4, 1, 4}, {4, 1, 4}), {0, -0.5, 0}));
    for (int i = 0; i < 3; ++i)
        add_rigid(world, moved(box({1, 1, 1}), {0, 0.5 + i, 0}));
    const Run run(world, 100, 0.01);
    CHECK(run.crossed == 0);
    const auto& top = dynamic_cast<const RigidBody&>(*world.bodies.back());
    CHECK(top.motion().centre().y() <= 2.5 + 1e-9);
    CHECK(top.motion().centre().y() > 2.5 - 1e-4);
    CHECK(top.motion().velocity_at(top.motion().centre()).norm() < 1e-6);
}

TEST_CASE(
    "contact by distance: a bullet of 200 m/s does not pass a plate of 2 mm, nor a turned cube its neighbours")
{
    World world;
    world.gravity.setZero();
    const RigidBody& plate = add_rigid(world, box({0.5, 0.002, 0.5}, {4, 1, 4}));
    const RigidBody& bullet = add_rigid(world, moved(sphere(0.02, 1), {0.03, 0.3, 0.01}), {0, -200, 0});
    const Vec3 momentum = bullet.linear_momentum();
    const Run run(world, 20, 0.01);
    CHECK(run.crossed == 0);
    CHECK(plate.motion().pose().to_body(bullet.centre()).y() > 0.02);
    CHECK((plate.linear_momentum() + bullet.linear_momentum() - momentum).norm() < 1e-9 * momentum.norm());
}

TEST_CASE(
    "contact by distance: in a part of a step that is not halved what would cross stands still, and is at rest")
{
    for (const double speed : {50.0, 200.0}) {
        World world;
        world.gravity.setZero();
        add_static(world, box({0.5, 0.002, 0.5}, {4, 1, 4}));
        const RigidBody& bullet = add_rigid(world, moved(sphere(0.02, 1), {0.03, 0.03, 0.01}),
                                            {0, -speed, 0});
        Solver solver = chapter08_solver({});
        solver.max_halvings = 0;
        Contacts contacts;
        double slowest = speed;
        for (int i = 0; i < 5; ++i) {
            advance(world, contacts, solver, 0.01);
            CHECK(!any_inside(world));
            slowest = std::min(slowest, bullet.motion().velocity_at(bullet.motion().centre()).norm());
        }
        CHECK(bullet.centre().y() > 0);
        CHECK(slowest < 1e-6 * speed);
    }
}

TEST_CASE(
    "contact by distance: cubes that fall onto each other end without crossing, and without energy from nothing")
{
    World world;
    add_static(world, moved(box({4, 1, 4}, {4, 1, 4}), {0, -0.5, 0}));
    for (int i = 0; i < 4; ++i)
        add_rigid(world, placed(box({0.4, 0.4, 0.4}),
                                Quaternion(Eigen::AngleAxisd(0.5 * i, Vec3(1, i, 2).normalized())),
                                {0.1 * (i % 2), 0.4 + 0.7 * i, 0.07 * i}));
    const double before = total_energy(world).total();
    const Run run(world, 100, 0.01);
    CHECK(run.crossed == 0);
    CHECK(total_energy(world).total() < before);
    for (const auto& body : world.bodies)
        CHECK(body->centre().y() > -0.6);
}

TEST_CASE("contact by distance: a ball that lands over a vertex of a floor's mesh rolls as on a plane")
{
    const auto speed_after = [](int cells, int steps) {
        World world;
        if (cells > 0)  // with 4 there is an inner vertex, and edges, where it lands
            add_static(world, moved(box({8, 1, 4}, {cells, 1, cells}), {2, -0.5, 0}));
        else
            world.planes.push_back({"ground"});
        RigidBody& ball = add_rigid(world, moved(sphere(0.2, 3), {0, 0.5, 0}), {2, 0, 0});
        const Run run(world, steps, 1.0 / 60);
        CHECK(run.crossed == 0);
        return ball.motion().velocity_at(ball.motion().centre()).x();
    };
    CHECK(speed_after(0, 15) == doctest::Approx(2 * 5.0 / 7).epsilon(0.02));  // it has just landed
    for (const int steps : {15, 60})
        for (const int cells : {1, 4})
            CHECK(speed_after(cells, steps) == doctest::Approx(speed_after(0, steps)).epsilon(0.01));
}

TEST_CASE(
    "contact by distance: a box that comes down beside the rim of a table lands as anywhere, in one whole step")
{
    // at 47 mm it passes the rim within a fiftieth of the step behind its landing
    for (const double to_rim : {0.03, 0.045, 0.0468, 0.0472, 0.0476, 0.048, 0.0484, 0.05, 0.06}) {
        CAPTURE(to_rim);
        World world;
        add_static(world, moved(box({0.3, 0.3, 0.3}), {-0.15, -0.15, 0}));  // its rim at x = 0
        const double dt = 0.01, height = 0.005;
        const RigidBody& glider = add_rigid(
            world, moved(box({0.1, 0.1, 0.1}), {-0.05 - to_rim, 0.05 + height, 0}), {10, -1, 0});
        const Run run(world, 1, dt, 0);
        const Vec3 velocity = glider.motion().velocity_at(glider.centre());
        CHECK(velocity.x() == doctest::Approx(10).epsilon(1e-4));
        CHECK(velocity.y() == doctest::Approx(-height / dt).epsilon(0.01));  // it ends in touch
        CHECK(world.work.parts == 1);
    }
}
