#include "chapters/08_contact_by_distance/begins_inside.hpp"
#include "chapters/13_other_solvers/incremental_potential.hpp"
#include "chapters/13_other_solvers/tests/small_scenes.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <string>

using namespace enduring;

namespace {

/// The distance at which one of so many corners of a cube of 1 m carries a part of a load, by bisection [m].
double distance_under(double force, double kappa, double d_hat)
{
    double near = 0, far = d_hat;
    for (int i = 0; i < 200; ++i) {
        const double d = 0.5 * (near + far);
        const double push = -kappa * log_barrier(d * d / (d_hat * d_hat)).slope * 2 * d / (d_hat * d_hat);
        (push > force ? near : far) = d;
    }
    return near;
}

/// What is said when a scene begins; empty if nothing.
std::string refusal(Scene scene)
{
    Contacts contacts;
    try {
        advance(scene.world, contacts, chapter13_barrier_solver(scene.contact), scene.dt);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("barrier: slope and bend are those of -(r - 1)^2 ln r, and all is 0 from r = 1 on")
{
    constexpr double h = 1e-6;
    for (const double r : {1e-3, 0.1, 0.5, 0.9, 0.999}) {
        CAPTURE(r);
        const BarrierValue here = log_barrier(r), more = log_barrier(r * (1 + h)),
                           less = log_barrier(r * (1 - h));
        CHECK(here.value == doctest::Approx((r - 1) * (r - 1) * std::log(1 / r)));
        CHECK((more.value - less.value) / (2 * h * r) == doctest::Approx(here.slope).epsilon(1e-6));
        CHECK((more.slope - less.slope) / (2 * h * r) == doctest::Approx(here.bend).epsilon(1e-6));
    }
    CHECK(log_barrier(1).value == 0);
    CHECK(log_barrier(1 - 1e-6).bend == doctest::Approx(0).epsilon(1e-5));
}

TEST_CASE("barrier: friction is the slope of its potential, and full from its bound on")
{
    constexpr double full = 0.02, h = 1e-7;
    for (const double y : {1e-4, 0.005, 0.0199, 0.03}) {
        CAPTURE(y);
        const SmoothFriction here = smooth_friction(y, full), more = smooth_friction(y + h, full),
                             less = smooth_friction(y - h, full);
        CHECK((more.potential - less.potential) / (2 * h) == doctest::Approx(here.force).epsilon(1e-6));
        CHECK((more.force - less.force) / (2 * h) == doctest::Approx(here.slope).epsilon(1e-4));
    }
    CHECK(smooth_friction(full / 2, full).force == doctest::Approx(0.75));
    CHECK(smooth_friction(full, full).force == 1);
}

TEST_CASE("barrier: a cube rests at the distance where four barriers carry it")
{
    for (const double mass : {1.0, 10.0}) {
        CAPTURE(mass);
        Scene scene = chapter07::scene_of({{mass, Vec3(0, 0.5, 0), 0}}, 0.01);
        run(scene, chapter13_barrier_solver(scene.contact), 1);
        const double d_hat = BarrierSettings{}.distance, kappa = mass * std::pow(d_hat / scene.dt, 2);
        CHECK(0.5 - scene.world.bodies[0]->centre().y() ==
              doctest::Approx(d_hat - distance_under(mass * 9.81 / 4, kappa, d_hat)).scale(0).epsilon(1e-4));
    }
}

TEST_CASE("barrier: on a slope a cube creeps at the speed where smooth friction holds it")
{
    const double angle = 20 * std::numbers::pi / 180, needs = std::tan(angle) / 0.5;
    const double speed = (1 - std::sqrt(1 - needs)) * BarrierSettings{}.friction_speed;  // 2 y - y^2 = needs
    Scene scene = one_cube(0, 20);
    run(scene, chapter13_barrier_solver(scene.contact), 1);
    CHECK(scene.world.bodies[0]->mean_velocity().norm() == doctest::Approx(speed).scale(0).epsilon(0.01));
}

TEST_CASE(
    "barrier: a thousand cubes' weight stays in front of the ground, and nothing that is thrown crosses")
{
    Scene heavy = chapter07::scene_of({{10, Vec3(0, 0.5, 0), 0}, {10000, Vec3(0, 1.5, 0), 0}}, 0.01);
    run(heavy, chapter13_barrier_solver(heavy.contact), 0.3);
    CHECK(heavy.world.bodies[1]->centre().y() >= 1.5 - 2 * BarrierSettings{}.distance);

    for (const double speed : {10.0, 30.0}) {
        CAPTURE(speed);
        Scene thrown = chapter07::scene_of({{10, Vec3(-3, 0, 0), 20, Vec3(1, 2, 3).normalized()},
                                            {10, Vec3(0, 0.2, 0.1), 50, Vec3(3, 1, 2).normalized()}},
                                           0.01);
        thrown.world.planes.clear();
        thrown.world.gravity.setZero();
        thrown.world.bodies[0]->kick({}, (Eigen::VectorXd(6) << 10 * speed, 0, 0, 0, 0, 0).finished(), 0.01);
        const Solver solver = chapter13_barrier_solver(thrown.contact);
        const auto energy = [&] {
            return thrown.world.bodies[0]->energy(Vec3::Zero()).kinetic +
                   thrown.world.bodies[1]->energy(Vec3::Zero()).kinetic;
        };
        const double start = energy();
        Contacts contacts;
        for (int step = 0; step < 60; ++step) {
            advance(thrown.world, contacts, solver, thrown.dt);
            CHECK(bodies_inside_each_other(thrown.world).empty());
            CHECK(energy() <= start * (1 + 1e-9));
        }
        CHECK(thrown.world.bodies[1]->mean_velocity().x() >= 0.2 * speed);  // it was hit
        CHECK(energy() <= 0.9 * start);
    }
}

TEST_CASE("barrier: what begins in touch begins, and what begins inside is refused by its names")
{
    CHECK(refusal(one_cube()).empty());
    CHECK(refusal(one_cube(-0.1)).find("a barrier cannot begin inside") != std::string::npos);
    Scene two = chapter07::scene_of({{10, Vec3(0, 0.5, 0), 0}, {10, Vec3(0.1, 1.45, 0), 0}}, 0.01);
    const std::string names = "'" + two.world.bodies[0]->name() + "' begins inside '" +
                              two.world.bodies[1]->name() + "'";
    CHECK(refusal(std::move(two)) == names + "; a barrier cannot begin inside");
}
