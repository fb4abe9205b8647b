#include "chapters/08_speculative_contacts/sliding_normal.hpp"
#include "chapters/08_speculative_contacts/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

/// In the plane of x and y, leaning from y towards -x by an angle, as the walls of a hollow do further along x.
Vec3 leaning(double angle) { return {-std::sin(angle), std::cos(angle), 0}; }

/// Along x, diving by an angle.
Vec3 diving(double angle) { return {std::cos(angle), -std::sin(angle), 0}; }

}  // namespace

TEST_CASE(
    "sliding normal: what comes along a surface that bends is at right angles to it, at any size and direction")
{
    Draw draw(3);
    for (const double scale : {1e-5, 1.0, 100.0})
        for (const double bend : {1e-3, 0.05, 0.4})
            for (const double part : {0.0, 0.3, 0.7, 0.99}) {
                const Quaternion turn = draw.turn();
                const Vec3 motion =
                    scale * diving(std::atan2(part * std::sin(bend), 1 + part * (1 - std::cos(bend))));
                const Vec3 found = turn.inverse() *
                                   sliding_normal(turn * leaning(0), turn * leaning(bend), turn * motion);
                CAPTURE(bend);
                CAPTURE(part);
                REQUIRE(found.norm() == doctest::Approx(1));
                CHECK(std::abs(found.dot(motion.normalized())) < 1e-12);
                CHECK(found.x() >= -1e-12);  // away from the end's normal
            }
}

TEST_CASE("sliding normal: what rises a little came along the surface of the start")
{
    for (const double bend : {0.3, -0.3}) {
        const Vec3 found = sliding_normal(leaning(0), leaning(bend), diving(bend > 0 ? -0.1 : 0.1));
        CHECK((found - leaning(0)).norm() < 1e-12);
    }
}

TEST_CASE("sliding normal: there is none on flat ground, for what hits the surface, and over a sharp corner")
{
    CHECK(sliding_normal(leaning(0.2), leaning(0.2), diving(0)).isZero(0));
    CHECK(sliding_normal(leaning(0.2), leaning(0.2), diving(0.3)).isZero(0));
    for (const double dive : {0.12, 1.0, 1.5})
        CHECK(sliding_normal(leaning(0), leaning(0.1), diving(dive)).isZero(0));
    CHECK(sliding_normal(leaning(0), leaning(0.9), diving(0)).isZero(0));
    CHECK(sliding_normal(Vec3::Zero(), leaning(0.1), diving(0)).isZero(0));
}

TEST_CASE("sliding normal: the ground is the nearest of the faces that hold the vertex' foot")
{
    const MovingSurface valley(hinge(0.3));
    const auto ground_of = [&](const Vec3& place) {
        const MovingSurface vertex(particle(place), Vec3(-1, 0, 0));
        Ground ground;
        for (const int face : {0, 1})
            ground.look_at(vertex.step(), 0, valley.step(), face);
        return ground;
    };
    const Vec3 level = Vec3::UnitY(), steep(std::sin(0.3), std::cos(0.3), 0);
    CHECK((ground_of({0.3, 0.02, 0.5}).normal - level).norm() < 1e-12);
    CHECK(ground_of({0.3, -0.02, 0.5}).distance == doctest::Approx(0.02));
    CHECK((ground_of({-0.3, 0.1, 0.5}).normal - steep).norm() < 1e-12);
    // above both: the nearer one
    CHECK((ground_of({0.01, 0.02, 0.5}).normal - level).norm() < 1e-12);
    CHECK((ground_of({-0.003, 0.02, 0.5}).normal - steep).norm() < 1e-12);
    CHECK(ground_of({0.5, 0.02, 3}).normal.isZero(0));
}

TEST_CASE(
    "sliding normal: the motion of a pair is without what gravity does to those of its bodies that move")
{
    for (const double dt : {0.002, 0.03}) {
        World world;
        world.gravity = Vec3(0, -8, 1);
        const SurfaceMesh cube = box(Vec3::Ones());
        for (const Vec3& velocity : {Vec3(1, 0, 0), Vec3(0, 0, 2)})
            world.bodies.push_back(
                std::make_unique<RigidBody>("cube", cube, mass_properties(cube, 1), velocity));
        world.bodies.push_back(std::make_unique<StaticBody>(
            "ground", SurfaceTopology(static_cast<int>(cube.vertices.size()), cube.faces), cube.vertices));
        for (const auto& body : world.bodies)
            body->predict(world.gravity, dt);
        Contact pair{ContactKind::vertex_face, 0, 1, 0, 0, {0, 0, 1, 2}, {1, -0.5, -0.25, -0.25}};
        CHECK((motion_without_gravity(world, pair, dt) - dt * Vec3(1, 0, -2)).norm() < 1e-12);
        pair.body_b = 2;
        CHECK((motion_without_gravity(world, pair, dt) - dt * Vec3(1, 0, 0)).norm() < 1e-12);
    }
}

TEST_CASE("sliding normal: of two faces that are equally near the first one is the ground")
{
    const MovingSurface valley({{{0, 0, 0}, {0, 0, 1}, {1, 1, 0.5}, {-1, 1, 0.5}}, {{0, 1, 2}, {1, 0, 3}}}),
        vertex(particle({0, 0.5, 0.5}));
    for (const int first : {0, 1}) {
        Ground ground;
        for (const int face : {first, 1 - first})
            ground.look_at(vertex.step(), 0, valley.step(), face);
        CHECK((ground.normal - valley.start().face_normal(first).normalized()).norm() < 1e-12);
    }
}
