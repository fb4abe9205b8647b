#include "chapters/01_particle_plane/solver.hpp"
#include "chapters/03_penalty_impulses/penalty_law.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/simulation/point_masses.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

namespace {

/// A force that grows with the square of the depth, k d^2 [k in N/m^2], looked at at the end of the step.
Vec3 quadratic_penalty(const PairStep& step, double, double k, double dt)
{
    const Vec3 normal = step.t1.side_1.cross(step.t1.side_2).normalized();
    const double depth = normal.dot(step.t1.offset);
    return depth < 0 ? Vec3(k * dt * depth * depth * normal) : Vec3(Vec3::Zero());
}

const Vec3 up = Vec3(0.3, 0.9, -0.2).normalized();
const double height = 0.01;

/// Three particles of 1 kg at `height` above a slope through the origin: a plane, or a triangle.
World above_a_slope(bool triangle, double speed)
{
    const Vec3 along = up.unitOrthogonal(), across = up.cross(along);
    const auto corner = [&](double degrees, double size) {
        const double angle = degrees * 3.14159265358979323846 / 180;
        return Vec3(size * (std::cos(angle) * along + std::sin(angle) * across));
    };
    World world;
    world.gravity.setZero();
    world.bodies.push_back(std::make_unique<PointMasses>(
        "particles",
        std::vector<Vec3>{corner(0, 0.1) + height * up, corner(120, 0.1) + height * up,
                          corner(240, 0.1) + height * up},
        std::vector<Face>{{0, 1, 2}}, 1.0, -speed * up));
    if (triangle)
        world.bodies.push_back(
            std::make_unique<StaticBody>("slope", SurfaceTopology(3, {{0, 1, 2}}),
                                         std::vector<Vec3>{corner(10, 2), corner(130, 2), corner(250, 2)}));
    else
        world.planes.push_back({"slope", Vec3::Zero(), up});
    return world;
}

ContactParameters quadratic(double k)
{
    ContactParameters parameters;
    parameters.stiffness = k;
    parameters.law = quadratic_penalty;
    return parameters;
}

}  // namespace

TEST_CASE("own law: a quadratic penalty pushes with k d^2 along the normal, on a plane and on a mesh alike")
{
    const double k = 700, dt = 0.01, speed = 3, depth = speed * dt - height;
    for (const bool triangle : {false, true}) {
        CAPTURE(triangle);
        World world = above_a_slope(triangle, speed);
        Contacts contacts;
        advance(world, contacts, chapter03_solver(quadratic(k)), dt);
        REQUIRE(contacts.size() == 3);
        for (const Contact& contact : contacts) {
            CHECK(contact.kind == (triangle ? ContactKind::vertex_face : ContactKind::vertex_plane));
            CHECK((contact.impulse - k * dt * depth * depth * up).norm() <= 1e-12 * k * dt);
            CHECK((world.bodies[0]->velocity(contact.feature_a) - (k * dt * depth * depth - speed) * up)
                      .norm() <= 1e-12);
        }
    }
}

TEST_CASE(
    "own law: under it a weight m sinks to sqrt(m g / k), less the fall of one step, on a plane and on a mesh alike")
{
    const double k = 20000, dt = 0.002, g = 9.81;
    for (const bool triangle : {false, true}) {
        CAPTURE(triangle);
        World world = above_a_slope(triangle, 0);
        world.gravity = -g * up;
        Contacts contacts;
        const Solver solver = chapter03_solver(quadratic(k));
        // a step takes k d dt^2 / m of the swing: what is left is 1e-9 of it
        for (int step = 0; step < 12000; ++step)
            advance(world, contacts, solver, dt);
        for (const Vec3& place : world.bodies[0]->positions_t0())
            CHECK(-up.dot(place) == doctest::Approx(std::sqrt(g / k) - g * dt * dt).epsilon(1e-6));
    }
}

TEST_CASE("own law: it takes the stiffness of a plane that has its own, in chapter 1's solver too")
{
    const double dt = 0.01, speed = 3, depth = speed * dt - height;
    for (const bool with_pairs : {false, true}) {
        CAPTURE(with_pairs);
        World world = above_a_slope(false, speed);
        world.planes[0].stiffness = 50;
        Contacts contacts;
        advance(world, contacts,
                with_pairs ? chapter03_solver(quadratic(700)) : chapter01_solver(quadratic(700)), dt);
        REQUIRE(contacts.size() == 3);
        CHECK((contacts[0].impulse - 50 * dt * depth * depth * up).norm() <= 1e-12);
    }
}

TEST_CASE("penalty law: against a triangle that stands still each is what it is against the plane through it")
{
    const double k = 700, dt = 0.01;
    for (const double speed : {0.5, 1.2, 3.0, 50.0})
        for (const NormalLaw& law : {NormalLaw(discrete_penalty), NormalLaw(continuous_penalty)}) {
            CAPTURE(speed);
            Vec3 impulse[2];
            for (const bool triangle : {false, true}) {
                World world = above_a_slope(triangle, speed);
                ContactParameters parameters = quadratic(k);
                parameters.law = law;
                Contacts contacts;
                advance(world, contacts, chapter03_solver(parameters), dt);
                REQUIRE(contacts.size() == (speed * dt > height ? 3 : 0));
                if (!contacts.empty())
                    impulse[triangle] = contacts[0].impulse;
                else
                    impulse[triangle].setZero();
            }
            CHECK((impulse[0] - impulse[1]).norm() <= 1e-9 * k * dt);
            CHECK((impulse[0].norm() > 0) == (speed * dt > height));
        }
}
