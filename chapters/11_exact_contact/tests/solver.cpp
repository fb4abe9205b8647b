#include "chapters/11_exact_contact/solver.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

/// Springs of this h, whatever the load, and the exact settings of a test.
Solver soft_solver(Scene& scene, double h, ExactStepSettings exact = {})
{
    scene.contact.wanted_depth = 1;
    ImplicitSettings settings;
    settings.stiffness.k_dt2_over_m = h / distance_parts.stiffer;
    return chapter11_solver(scene.contact, settings, std::move(exact));
}

}  // namespace

TEST_CASE("exact steps: a stack on springs of h = 100 rests at no depth")
{
    Scene scene = chapter07::scene_of(chapter07::stack_of(4), 0.01);
    const Solver solver = soft_solver(scene, 100);
    Contacts contacts;
    for (int step = 0; step < 100; ++step)
        advance(scene.world, contacts, solver, scene.dt);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(std::abs(scene.world.bodies[i]->centre().y() - (0.5 + static_cast<double>(i))) <= 1e-9);
}

TEST_CASE(
    "exact steps: a scene that asks for exact contact runs under this solver, and under no chapter before")
{
    Scene scene = chapter07::scene_of(chapter07::stack_of(1), 0.01);
    scene.asks_exact = "scene.json: /contact/exact";
    CHECK_NOTHROW(require_asked(scene, chapter11_solver(scene.contact)));
    CHECK_THROWS_AS(require_asked(scene, chapter10_solver(scene.contact)), InputError);
}

TEST_CASE("exact steps: a cube lands on the ground and not in it, in the step in which it lands")
{
    Scene scene = chapter07::scene_of({{10, Vec3(0, 0.9, 0)}}, 0.01);
    const Solver solver = soft_solver(scene, 10);
    Contacts contacts;
    double lowest = 1;
    for (int step = 0; step < 60; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        lowest = std::min(lowest, scene.world.bodies[0]->centre().y());
    }
    CHECK(lowest >= 0.5 - 1e-6);
    CHECK(std::abs(scene.world.bodies[0]->centre().y() - 0.5) <= 1e-9);
}

TEST_CASE("exact steps: a cube that slides is braked by Coulomb's friction and is not lifted")
{
    Scene scene = chapter07::scene_of({{10, Vec3(0, 0.5, 0)}}, 0.01, 0, 0.4, 0.4);
    for (int corner = 0; corner < 8; ++corner)
        scene.world.bodies[0]->apply_impulse(corner, Vec3(10.0 / 8 * 3, 0, 0));
    const Solver solver = soft_solver(scene, 100);
    Contacts contacts;
    for (int step = 0; step < 30; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        CHECK(std::abs(scene.world.bodies[0]->centre().y() - 0.5) <= 1e-8);
        const double expected = 3 - 0.4 * 9.81 * 0.01 * (step + 1);
        CHECK(scene.world.bodies[0]->mean_velocity().x() == doctest::Approx(expected).epsilon(1e-5));
    }
}

TEST_CASE("exact steps: a cube on a slope that friction holds does not creep")
{
    Scene scene = chapter07::scene_of({{10, Vec3(0, 0.5, 0)}}, 0.01, 20, 0.5, 0.5);
    const Solver solver = soft_solver(scene, 100);
    Contacts contacts;
    for (int step = 0; step < 200; ++step)
        advance(scene.world, contacts, solver, scene.dt);
    CHECK(std::abs(scene.world.bodies[0]->centre().x()) <= 1e-7);
}

TEST_CASE("exact steps: passes are bounded, and a bound that is reached is told with what is left")
{
    Scene scene = chapter07::scene_of(chapter07::stack_of(4), 0.01);
    int told = 0, most = 0;
    double left = 0;
    const Solver solver = soft_solver(scene, 1, {.max_passes = 2, .record = [&](const PassRecord& record) {
                                                     told += !record.reached;
                                                     most = std::max(most, record.passes);
                                                     left = std::max(left, record.moved);
                                                 }});
    Contacts contacts;
    advance(scene.world, contacts, solver, scene.dt);
    CHECK(told > 0);
    CHECK(most == 2);
    CHECK(left > ExactStepSettings{}.tolerance);
}

TEST_CASE(
    "exact steps: at the end of a step the load alone holds the force, and no energy is left in springs")
{
    Scene scene = chapter07::scene_of({{10, Vec3(0, 0.5, 0)}}, 0.01);
    const Solver solver = soft_solver(scene, 1);
    Contacts contacts;
    for (int step = 0; step < 150; ++step)
        advance(scene.world, contacts, solver, scene.dt);
    double load = 0;
    for (const Contact& contact : contacts) {
        load += contact.spring.load;
        CHECK(std::abs(contact.spring.rest_offset) <= 1e-9);
    }
    CHECK(load == doctest::Approx(10 * 9.81));
    // what such loads would be on springs, as it was at the start of the step
    CHECK(scene.world.attempt.springs > 0);
    CHECK(std::abs(scene.world.attempt.added_energy) <= 1e-3 * scene.world.attempt.springs);
}

TEST_CASE("exact steps: a stack on springs too soft for its passes does not sway more and more")
{
    Scene scene = chapter07::scene_of(chapter07::stack_of(10), 0.01);
    const Solver solver = soft_solver(scene, 10, {.record = [](const PassRecord&) {}});
    Contacts contacts;
    for (int step = 0; step < 400; ++step)
        advance(scene.world, contacts, solver, scene.dt);
    CHECK(std::abs(scene.world.bodies.back()->centre().y() - 9.5) <= 1e-6);
}

TEST_CASE("exact steps: a cube that begins deep inside the ground is let out, and not thrown")
{
    Scene scene = chapter07::scene_of({{10, Vec3(0, 0.3, 0)}}, 0.01);
    const Solver solver = soft_solver(scene, 100);
    Contacts contacts;
    double highest = 0;
    for (int step = 0; step < 400; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        highest = std::max(highest, scene.world.bodies[0]->centre().y());
    }
    CHECK(highest <= 0.5 + 1e-3);
    CHECK(scene.world.bodies[0]->centre().y() == doctest::Approx(0.5).epsilon(1e-3));
}
