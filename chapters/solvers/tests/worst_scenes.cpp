#include "chapters/solvers/worst_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/random_scenes.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "chapters/solvers/bicycle_chain.hpp"
#include "common/geometry/surface_checks.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

void run(Scene& scene, int steps)
{
    const Solver solver = chapter10_solver(scene.contact);
    Contacts contacts;
    for (int step = 0; step < steps; ++step)
        advance(scene.world, contacts, solver, scene.dt);
}

Vec3 middle_of(const Body& body)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : body.positions_t0())
        box.extend(vertex);
    return box.center();
}

}  // namespace

TEST_CASE("worst scenes: a ball hits a wall, and gives it what momentum it loses")
{
    for (const int columns : {2, 3, 4})
        for (const int rows : {3, 4, 5}) {
            CAPTURE(columns);
            CAPTURE(rows);
            Scene scene = solvers::hit_wall(columns, rows);
            const auto& bodies = scene.world.bodies;
            const auto bricks = static_cast<std::size_t>(columns * rows);
            REQUIRE(bodies.size() == bricks + 1);
            scene.world.gravity = Vec3::Zero();
            scene.world.planes.clear();  // the ground would take momentum
            run(scene, 4);
            const auto momentum_of = [&](std::size_t body) {
                return bodies[body]->mass() * bodies[body]->mean_velocity().z();
            };
            double wall = 0;
            for (std::size_t brick = 0; brick < bricks; ++brick)
                wall += momentum_of(brick);
            CHECK(wall > 100);
            CHECK(wall + momentum_of(bricks) == doctest::Approx(200 * 15).epsilon(1e-6));
        }
}

TEST_CASE("worst scenes: poured spheres stay in their box, and run out of the hopper's hole")
{
    Scene box = solvers::poured_spheres(20), funnel = solvers::hopper(20);
    run(box, 60);
    run(funnel, 60);
    const auto radius_of = [](const Body& body) { return std::hypot(body.centre().x(), body.centre().z()); };
    for (const auto& body : box.world.bodies) {
        CHECK(std::abs(body->centre().x()) < 0.46);
        CHECK(std::abs(body->centre().z()) < 0.46);
        CHECK(body->centre().y() > 0.09);
    }
    double lowest = 1;
    for (const auto& body : funnel.world.bodies)
        if (!body->is_static()) {
            lowest = std::min(lowest, body->centre().y());
            CHECK(radius_of(*body) < 1);
        }
    CHECK(lowest < 0.3);
}

TEST_CASE("worst scenes: a chain sags by the play of its links, which stay in each other")
{
    Scene scene = solvers::hanging_chain(7);
    const auto& bodies = scene.world.bodies;
    run(scene, 100);
    CHECK(bodies[3]->centre().y() < 2.995);
    for (std::size_t link = 1; link < bodies.size(); ++link)
        CHECK((bodies[link]->centre() - bodies[link - 1]->centre()).norm() < 0.0801);  // play taken up
}

TEST_CASE("worst scenes: a bicycle chain rests, and hung by one link it stays together")
{
    check_surface(solvers::ChainLink::outer(), "outer link");
    check_surface(solvers::ChainLink::inner(), "inner link");
    Scene resting = solvers::bicycle_chain(6);
    run(resting, 10);
    for (const auto& link : resting.world.bodies)
        CHECK(link->mean_velocity().norm() < 1e-5);
    CHECK_FALSE(chapter08::any_crossing(resting.world));

    Scene hung = solvers::bicycle_chain(6);
    auto& bodies = hung.world.bodies;
    const Body& first = *bodies[0];
    bodies[0] = std::make_unique<StaticBody>(
        "held", first.surface(), std::vector<Vec3>(first.positions_t0().begin(), first.positions_t0().end()));
    hung.world.planes.clear();
    hung.world.gravity = Vec3(0, 0, 9.81);
    const double height = bodies[3]->centre().z();
    run(hung, 20);
    CHECK_FALSE(chapter08::any_crossing(hung.world));
    CHECK(bodies[3]->centre().z() > height + 0.005);
    for (std::size_t link = 0; link < 6; ++link)
        CHECK((middle_of(*bodies[(link + 1) % 6]) - middle_of(*bodies[link])).norm() <
              solvers::ChainLink::pitch + 2e-4);
}
