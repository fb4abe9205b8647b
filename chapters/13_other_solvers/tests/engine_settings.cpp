#include "chapters/13_other_solvers/impedance.hpp"
#include "chapters/13_other_solvers/tests/small_scenes.hpp"

#include <doctest/doctest.h>

#include <array>
#include <numbers>

using namespace enduring;

namespace {

constexpr double t = 0.95 * 0.02;  ///< d_max times the time constant of MuJoCo's defaults

/// How far the last cube of a scene is below the place where it begins [m].
double sunk(Scene scene, const Solver& solver, double seconds)
{
    const double from = scene.world.bodies.back()->centre().y();
    run(scene, solver, seconds);
    return from - scene.world.bodies.back()->centre().y();
}

}  // namespace

TEST_CASE(
    "convex relaxation: with MuJoCo's impedance a particle has the part d of the reference acceleration and the rest of its own")
{
    constexpr double dt = 0.002, m = 3, g = 9.81;
    // by hand: two parabolas from 0.9 to 0.95 over a millimetre
    for (const auto& row : std::array<std::array<double, 2>, 4>{
             {{0.25e-3, 0.90625}, {0.5e-3, 0.925}, {0.75e-3, 0.94375}, {5e-3, 0.95}}})
        for (const double u : {0.0, -0.3, 0.01}) {
            const double depth = row[0], d = row[1];
            CAPTURE(depth);
            const RegularisedContact contact = impedance_contact({}, -depth, {u, 0, 0}, 1 / m, 0, dt);
            const double without = u - g * dt, w = 1 / m;
            // the end of the step, where the impulse of the contact is that which leads there
            const double end = (without + w / contact.r_normal * contact.free_speed) /
                               (1 + w / contact.r_normal);
            const double impulse = relaxed_answer(contact, {end, 0, 0}).impulse.x();
            const double b = 2 / t, k = d / (t * t), asked = (1 - d) * -g + d * (-b * u + k * depth);
            CHECK(end == doctest::Approx(without + impulse / m).scale(0).epsilon(1e-12));
            CHECK((end - u) / dt == doctest::Approx(asked).scale(0).epsilon(1e-9));
        }
    CHECK(relaxed_answer(impedance_contact({}, 1e-9, {-5, 0, 0}, 1, 0.5, dt), {-5, 1, 0}).impulse.isZero(0));
}

TEST_CASE("convex relaxation: MuJoCo's pyramid, while all its edges push, is the cone of its settings")
{
    constexpr double dt = 0.002, mu = 0.4, w = 0.7, depth = 2e-3, d = 0.95;
    const Vec3 start(-0.02, 0.003, -0.002), end(-0.01, 0.002, 0.004);
    Vec3 sum = Vec3::Zero();
    for (const Vec3& edge : {Vec3(1, mu, 0), Vec3(1, -mu, 0), Vec3(1, 0, mu), Vec3(1, 0, -mu)}) {
        const double r = 2 * mu * mu * (1 - d) / d * (1 + mu * mu) * w;
        const double free = edge.dot(start) - dt * (2 / t * edge.dot(start) - d / (t * t) * depth);
        REQUIRE(free > edge.dot(end));
        sum += (free - edge.dot(end)) / r * edge;
    }
    const Vec3 found = relaxed_answer(impedance_contact({}, -depth, start, w, mu, dt), end).impulse;
    CHECK((found - sum).norm() <= 1e-12 * sum.norm());
}

TEST_CASE("convex relaxation: with MuJoCo's settings a heavy cube sinks as deep as under MuJoCo itself")
{
    const Scene scene = chapter07::scene_of(chapter07::stack_of(3, 10, 10000), 0.002);
    const double found = sunk(chapter07::scene_of(chapter07::stack_of(3, 10, 10000), 0.002),
                              chapter13_relaxation_solver(scene.contact, mujoco_settings()), 1.5);
    // each is deeper than a millimetre: load times R of an edge over four edges a pair and k
    const auto depth = [](double load, int pairs, double inverse_mass) {
        constexpr double d = 0.95, mu = 0.5;
        return load * 2 * mu * mu * (1 - d) / d * (1 + mu * mu) * inverse_mass * t * t / (4 * pairs * d);
    };
    const double g = 9.81;
    const double formula = depth(10020 * g, 4, 0.1) + depth(10010 * g, 8, 0.2) + depth(10000 * g, 8, 0.1001);
    CHECK(formula == doctest::Approx(19.187e-3).scale(0).epsilon(1e-4));  // measured/rows.csv
    CHECK(found == doctest::Approx(formula).scale(0).epsilon(2e-3));
}

TEST_CASE(
    "soft step: with Rapier's settings a cube rests where springs of 60 Hz carry it, as under Rapier itself")
{
    const double omega = 2 * std::numbers::pi * 60, formula = 9.81 / (omega * omega);
    CHECK(formula == doctest::Approx(69e-6).scale(0).epsilon(1e-2));  // of a cube under Rapier 0.21
    const double found = sunk(one_cube(), chapter13_soft_step_solver(one_cube().contact, rapier_settings()),
                              3);
    CHECK(found == doctest::Approx(formula).scale(0).epsilon(1e-3));
}

TEST_CASE(
    "sequential impulses: with Bullet's settings a shallow depth leaves a velocity behind, and a deep one none")
{
    SequentialSettings settings = bullet_settings();
    settings.iterations = 200;
    for (const double depth : {0.03, 0.05}) {
        CAPTURE(depth);
        Scene scene = one_cube(-depth);
        const Solver solver = chapter13_sequential_solver(scene.contact, settings);
        run(scene, solver, scene.dt);
        CHECK(0.5 - scene.world.bodies[0]->centre().y() ==
              doctest::Approx(0.8 * depth).scale(0).epsilon(0.02));
        const double left = scene.world.bodies[0]->mean_velocity().y(), push = 0.2 * depth / scene.dt;
        CHECK(left == doctest::Approx(depth < 0.04 ? push : 0).scale(1).epsilon(0.02));
    }
}

TEST_CASE("sequential impulses: a warm start begins with its part of the last impulses")
{
    // without sweeps, a cube at rest falls by what the start lacks of its weight
    SequentialSettings settings = bullet_settings();
    MethodStep step;
    step.dt = 0.01;
    settings.iterations = 0;
    step.bodies.resize(2);
    MovingBody& body = step.bodies[0];
    body.moves = true;
    body.inverse_mass = 0.1;
    body.inverse_in_body = body.inertia_in_body = Mat3::Identity();
    body.gravity = Vec3(0, -9.81, 0);
    ContactPoint point;
    point.a = 0;
    point.b = 1;
    point.on_a = point.on_b = Vec3::Zero();
    point.normal = Vec3::UnitY();
    point.tangent_1 = Vec3::UnitX();
    point.tangent_2 = Vec3::UnitZ();
    point.impulse = Vec3(0, 10 * 9.81 * step.dt, 0);
    step.points.push_back(point);
    sequential_impulses(step, settings);
    CHECK(step.bodies[0].velocity.y() == doctest::Approx(-0.15 * 9.81 * step.dt).scale(0).epsilon(1e-9));
}
