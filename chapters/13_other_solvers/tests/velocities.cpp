#include "chapters/13_other_solvers/tests/small_scenes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <numbers>

using namespace enduring;

namespace {

/// The velocity of the middle cube of three after a step.
Vec3 after_a_step(const SequentialSettings& settings, int steps)
{
    Scene scene = chapter07::scene_of(chapter07::stack_of(3), 0.01, 5);
    run(scene, chapter13_sequential_solver(scene.contact, settings), steps * scene.dt);
    return scene.world.bodies[1]->mean_velocity();
}

}  // namespace

TEST_CASE("sequential impulses: in the limit of many sweeps a warm start makes no difference")
{
    SequentialSettings warm{.iterations = 3000}, cold = warm;
    cold.warm_start = 0;
    CHECK((after_a_step(warm, 3) - after_a_step(cold, 3)).norm() <= 1e-9);
    warm.iterations = cold.iterations = 3;
    CHECK(after_a_step(cold, 3).norm() >= 3 * after_a_step(warm, 3).norm());
}

TEST_CASE("sequential impulses: each step takes the part baumgarte of what is deeper than the slop")
{
    for (const bool split : {true, false}) {
        CAPTURE(split);
        Scene scene = one_cube(-0.105);
        const SequentialSettings settings{.iterations = 500,
                                          .split_from = split ? 0 : std::numeric_limits<double>::infinity()};
        const Solver solver = chapter13_sequential_solver(scene.contact, settings);
        double depth = 0.1;  // beyond the slop of 5 mm
        Contacts contacts;
        for (int step = 0; step < (split ? 8 : 1); ++step) {
            advance(scene.world, contacts, solver, scene.dt);
            depth *= 0.8;
            CHECK(0.5 - scene.world.bodies[0]->centre().y() - 0.005 ==
                  doctest::Approx(depth).scale(0).epsilon(1e-3));
        }
        // a split push leaves nothing; the other one has thrown the cube
        CHECK((scene.world.bodies[0]->mean_velocity().norm() < 1e-6) == split);
    }
}

TEST_CASE("soft step: softness is the implicit step of a damped spring on the mass that the contact feels")
{
    for (const double hertz : {1.0, 30.0, 200.0})
        for (const double zeta : {0.1, 1.0, 10.0}) {
            const double h = 0.0025, m = 3, x = -0.01, v = 0.4;
            const double omega = 2 * std::numbers::pi * hertz, k = m * omega * omega,
                         c = 2 * zeta * m * omega;
            const double implicit = (m * v - h * k * x) / (m + h * c + h * h * k);
            const Softness soft = softness(hertz, zeta, h);
            // one row, solved until its impulse stays
            double sum = 0, now = v;
            for (int i = 0; i < 20000; ++i) {
                const double change = -m * soft.mass_scale * (now + soft.bias_rate * x) -
                                      soft.impulse_scale * sum;
                sum += change;
                now += change / m;
            }
            CHECK(now == doctest::Approx(implicit).scale(0).epsilon(1e-9));
        }
    CHECK(softness(0, 1, 0.01).mass_scale == 1);
}

TEST_CASE("soft step: what begins inside is pushed out no faster than the push speed")
{
    Scene scene = one_cube(-0.4);
    const Solver solver = chapter13_soft_step_solver(scene.contact);
    double before = scene.world.bodies[0]->centre().y(), fastest = 0;
    Contacts contacts;
    for (int step = 0; step < 40; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        const double y = scene.world.bodies[0]->centre().y();
        fastest = std::max(fastest, (y - before) / scene.dt);
        before = y;
    }
    CHECK(fastest <= 3.0001);
    CHECK(fastest >= 1);
    CHECK(before == doctest::Approx(0.495).scale(0).epsilon(5e-3));
}

TEST_CASE(
    "convex relaxation: the impulse is minus the slope of the potential, and the Hessian minus that of the impulse")
{
    const RegularisedContact contact{0.02, 0.01, 0.3, 0.6};
    constexpr double step = 1e-6;
    int holds = 0, slides = 0, open = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 v(0.6 * std::sin(1.7 * i), 0.2 * std::sin(0.3 * i * i), 0.2 * std::cos(2.3 * i));
        const RelaxedAnswer answer = relaxed_answer(contact, v);
        const double side = answer.impulse.tail<2>().norm() - 0.6 * answer.impulse.x();
        (answer.impulse.isZero(0) ? open : side < -1e-9 ? holds : slides)++;
        CHECK(side <= 1e-12);
        for (int k = 0; k < 3; ++k) {
            const Vec3 by = step * Vec3::Unit(k);
            const RelaxedAnswer more = relaxed_answer(contact, v + by),
                                less = relaxed_answer(contact, v - by);
            CHECK(std::abs((more.potential - less.potential) / (2 * step) + answer.impulse[k]) <= 1e-4);
            const Vec3 slope = -(more.impulse - less.impulse) / (2 * step);
            if ((relaxed_answer(contact, v + by).hessian - answer.hessian).norm() <
                0.1 * answer.hessian.norm())
                CHECK((slope - answer.hessian.col(k)).norm() <= 1e-3 * (1 + answer.hessian.norm()));
        }
    }
    CHECK(std::min({holds, slides, open}) >= 20);
}

TEST_CASE("convex relaxation: a cube rests at the depth of its regularisation")
{
    Scene scene = one_cube();
    run(scene, chapter13_relaxation_solver(scene.contact), 2);
    // of a corner: w = 1/m + r x n J^-1 r x n = 4/m along the normal, and as much along each tangent on
    // average
    const double dt = scene.dt, load = 10 * 9.81 * dt / 4, pi = std::numbers::pi;
    const double w = (4 + 4 + 4) / 3.0 / 10;
    const double depth = load * w / (4 * pi * pi) * 2 * dt;
    CHECK(0.5 - scene.world.bodies[0]->centre().y() == doctest::Approx(depth).scale(0).epsilon(1e-6));
}

TEST_CASE("convex relaxation: a cube that slides floats at mu v dt")
{
    Scene scene = one_cube(0, 40);
    run(scene, chapter13_relaxation_solver(scene.contact), 1);
    const double v = scene.world.bodies[0]->mean_velocity().norm();
    CHECK(scene.world.bodies[0]->centre().y() - 0.5 ==
          doctest::Approx(0.5 * v * scene.dt).scale(0).epsilon(0.01));
}
