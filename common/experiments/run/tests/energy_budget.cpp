#include "common/experiments/run/energy_budget.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/tests/triangle_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

using namespace enduring;

namespace {

/// Three points of 1 kg above the ground (or in it), of which each has its pair from the first step on.
Scene points_above_ground(double height, double stiffness, double dt)
{
    Scene scene;
    scene.name = "points";
    scene.dt = dt;
    scene.duration = 400 * dt;
    scene.contact.method = PenaltyMethod::discrete;
    scene.contact.stiffness = stiffness;
    scene.world.gravity = {0, -10, 0};
    scene.world.planes.push_back({"ground", Vec3::Zero(), Vec3::UnitY()});
    scene.world.bodies.push_back(triangle("points", height));
    return scene;
}

/// The smallest contact there is: pairs with the ground that live for ever, and discrete forces.
Solver ground_solver(const ContactParameters& contact)
{
    Solver solver;
    solver.name = "springs";
    solver.append(StepStage::detect, "all vertices", [](World& world, Contacts& contacts, double) {
        for (int vertex = static_cast<int>(contacts.size());
             vertex < world.bodies[0]->surface().vertex_count(); ++vertex)
            contacts.push_back(
                {ContactKind::vertex_plane, 0, 0, vertex, -1, {vertex, -1, -1, -1}, {1, 0, 0, 0}});
    });
    solver.append(StepStage::respond, "springs", [contact](World& world, Contacts& contacts, double dt) {
        for (Contact& pair : contacts)
            pair.impulse = -contact.stiffness * dt * std::min(0.0, contact_geometry(world, pair, 1).depth) *
                           Vec3::UnitY();
    });
    return solver;
}

/// A pass that once, in step 10, multiplies a speed along x.
Solver kick(double factor)
{
    Solver solver;
    solver.append(StepStage::refresh, "kick", [factor](World& world, Contacts&, double) {
        Body& body = *world.bodies[0];
        for (int vertex = 0; world.step == 9 && vertex < body.surface().vertex_count(); ++vertex)
            body.apply_impulse(vertex, (factor - 1) * body.mass() / 3 * body.velocity(vertex));
        body.update_prediction(0.1);
    });
    return solver;
}

}  // namespace

TEST_CASE(
    "energy budget: what falls and bounces on springs that the step can bear holds no more than was put in")
{
    for (const double height : {0.0, 0.3, 5.0})
        for (const double h : {0.01, 0.3, 1.2}) {  // of k dt^2 / m, where 4/3 is the limit
            CAPTURE(height);
            CAPTURE(h);
            const double dt = 0.01;
            Scene scene = points_above_ground(height, h / (dt * dt), dt);
            CHECK_NOTHROW(run(scene, ground_solver(scene.contact)));
        }
}

TEST_CASE(
    "energy budget: springs that are too stiff for the step end the run, and it says where, who, n k and the stable step")
{
    Scene scene = points_above_ground(0.3, 20000, 0.01);
    EnergyProbe energy;
    std::string said;
    try {
        run(scene, ground_solver(scene.contact), {&energy});
    } catch (const std::runtime_error& failure) {
        said = failure.what();
    }
    CAPTURE(said);
    const std::string step = "step " + std::to_string(scene.world.step) + ", time ";
    for (const std::string& part :
         {std::string("points, springs: "), step, std::string("'points' and 'ground'"),
          std::string("3 pairs"), std::string("n k = 60000 N/m"),
          // sqrt(4/3 * 3 / 60000)
          std::string("dt = 0.00816 s"), std::string("Make dt shorter")})
        CHECK(said.find(part) != std::string::npos);
    CHECK(scene.world.step > 1);
    CHECK(scene.world.step < 400);
    // the probes have seen the last step
    CHECK(energy.table().rows().size() == static_cast<std::size_t>(scene.world.step) + 1);
}

TEST_CASE("energy budget: where the solver finds the stiffness, the scene's is not blamed")
{
    Scene scene = points_above_ground(-0.1, 1000, 0.01);
    EnergyBudget budget(scene);
    Contact pair{ContactKind::vertex_plane, 0, 0, 0, -1, {0, -1, -1, -1}, {1, 0, 0, 0}};
    pair.state = ContactState::answered;
    pair.spring.stiffness = 1e9;
    std::optional<std::string> said;
    for (scene.world.step = 2; scene.world.step < 12; ++scene.world.step)
        said = budget.exceeded(scene.world, {pair});
    REQUIRE(said.has_value());
    CAPTURE(*said);
    CHECK(said->find("energy out of nothing") != std::string::npos);
    CHECK(said->find("The solver finds the stiffness") != std::string::npos);
    CHECK(said->find("Look for an unsolved step before this one") != std::string::npos);
    CHECK(said->find("horter") == std::string::npos);
}

TEST_CASE("energy budget: what shows a failure on purpose says so and runs to its end")
{
    Scene scene = points_above_ground(0.3, 20000, 0.01);
    RunResult result = run(scene, ground_solver(scene.contact), {}, failure_on_purpose({50, {}}));
    CHECK(result.steps == 50);
    REQUIRE(result.energy_gain.has_value());
    CHECK(result.energy_gain->find("energy out of nothing") != std::string::npos);
    Scene calm = points_above_ground(0.3, 100, 0.01);
    CHECK_FALSE(run(calm, ground_solver(calm.contact), {}, failure_on_purpose()).energy_gain.has_value());
}

TEST_CASE("energy budget: what a body holds by beginning inside the ground was put in")
{
    Scene scene = points_above_ground(-0.3, 1000, 0.001);  // 135 J in springs, 9 J of weight
    scene.duration = 1;
    EnergyBudget budget(scene);
    Contacts contacts;
    const Solver solver = ground_solver(scene.contact);
    double highest = 0;
    while (scene.world.step < 1000) {
        advance(scene.world, contacts, solver, scene.dt);
        CHECK_FALSE(budget.exceeded(scene.world, contacts).has_value());
        highest = std::max(highest, scene.world.bodies[0]->positions_t0()[0].y());
    }
    CHECK(highest > 3);  // thrown out
    CHECK(budget.added_energy() == doctest::Approx(135).epsilon(0.05));
}

TEST_CASE("energy budget: a tenth is tolerated, and more is not")
{
    for (const double gain : {0.05, 0.09, 0.11, 0.5}) {
        CAPTURE(gain);
        Scene scene;
        scene.dt = 0.1;
        scene.duration = 5;
        scene.world.gravity.setZero();
        scene.world.bodies.push_back(triangle("points", 1, {2, 0, 0}));
        const RunResult result = run(scene, kick(std::sqrt(1 + gain)), {}, failure_on_purpose());
        CHECK(result.energy_gain.has_value() == (gain > 0.1));
        if (gain == 0.5)
            // three of ten steps with half as much again
            CHECK(result.energy_gain->find("step 12, time 1.2 s") == 0);
    }
}

TEST_CASE(
    "energy budget: height is counted from the lowest place, so a fall puts in no more than its own depth")
{
    // 1000 m up, or down: where the origin lies does not matter.
    for (const double origin : {0.0, 1000.0, -1000.0}) {
        CAPTURE(origin);
        Scene scene = points_above_ground(origin, 1, 0.01);
        scene.world.planes.clear();
        EnergyBudget budget(scene);
        Contacts contacts;
        for (int step = 0; step < 100; ++step)
            advance(scene.world, contacts, {}, scene.dt), budget.exceeded(scene.world, contacts);
        CHECK(budget.added_energy() == doctest::Approx(3 * 10 * 5.05));  // 100 steps of symplectic Euler
        double mean = 0;
        for (int step = 91; step <= 100; ++step)
            mean += 3 * 0.5 * std::pow(0.1 * step, 2) / 10;  // it is at its lowest place all the time
        CHECK(budget.held() == doctest::Approx(mean));
    }
}

TEST_CASE(
    "energy budget: the stretch of friction's springs counts, and the depth of a held or a resolved pair does not")
{
    Scene scene = points_above_ground(-0.1, 1000, 0.01);
    scene.world.gravity.setZero();
    scene.contact.friction = MassSplitting{.spring = 500};
    EnergyBudget budget(scene);
    Contact pressed{ContactKind::vertex_plane, 0, 0, 0, -1, {0, -1, -1, -1}, {1, 0, 0, 0}};
    pressed.state = ContactState::answered;
    Contact held = pressed, resolved = pressed;
    pressed.spring.stretch = {0.2, 0, 0};
    held.hold(true);
    resolved.resolved = true;
    for (scene.world.step = 2; scene.world.step < 12; ++scene.world.step)
        budget.exceeded(scene.world, {pressed, held, resolved});
    CHECK(budget.held() == doctest::Approx(0.5 * 1000 * 0.01 + 0.5 * 500 * 0.04));
}

TEST_CASE(
    "energy budget: the work of a rest offset that fades is put in, and a body that is lifted out keeps to it")
{
    Scene scene = points_above_ground(-0.5, 3000, 0.01);
    scene.contact.max_depenetration_velocity = 0.35;
    Solver solver = ground_solver(scene.contact);
    solver.append(StepStage::refresh, "fade rest offsets", [&](World&, Contacts& contacts, double dt) {
        for (Contact& pair : contacts)
            pair.spring.rest_offset = std::min(
                0.0, pair.spring.rest_offset + *scene.contact.max_depenetration_velocity * dt);
    });
    solver.append(StepStage::detect, "begin uncompressed", [](World& world, Contacts& contacts, double) {
        for (Contact& pair : contacts)
            if (world.step == 0)
                pair.spring.rest_offset = -0.5;
    });
    solver.replace("springs", "springs", [](World& world, Contacts& contacts, double dt) {
        for (Contact& pair : contacts)
            pair.impulse = -3000 * dt *
                           std::min(0.0, contact_geometry(world, pair, 1).depth - pair.spring.rest_offset) *
                           Vec3::UnitY();
    });
    EnergyBudget budget(scene);
    Contacts contacts;
    while (scene.world.step < 200) {
        advance(scene.world, contacts, solver, scene.dt);
        CHECK_FALSE(budget.exceeded(scene.world, contacts).has_value());
    }
    CHECK(scene.world.bodies[0]->positions_t0()[0].y() > -0.02);
    CHECK(budget.lifted() == doctest::Approx(3 * 10 * 0.5).epsilon(0.05));
    CHECK(budget.added_energy() == doctest::Approx(budget.lifted()).epsilon(0.05));
}

TEST_CASE("energy budget: what drives a body from outside was put in, and what brakes it was taken")
{
    for (const bool booked : {true, false}) {
        CAPTURE(booked);
        Scene scene;
        scene.dt = 0.01;
        scene.duration = 3;
        scene.world.gravity.setZero();
        scene.world.bodies.push_back(triangle("points", 1, {2, 0, 0}));
        Solver solver;
        solver.append(StepStage::refresh, "drive", [booked](World& world, Contacts&, double dt) {
            // on for a second, against it for another; then without a force
            const double force = world.step < 100 ? 30 : world.step < 200 ? -30 : 0;
            for (int vertex = 0; vertex < 3; ++vertex)
                if (booked)
                    push_from_outside(world, 0, vertex, Vec3(force * dt / 3, 0, 0));
                else
                    world.bodies[0]->apply_impulse(vertex, Vec3(force * dt / 3, 0, 0));
            world.bodies[0]->update_prediction(dt);
        });
        const RunResult result = run(scene, solver, {}, failure_on_purpose());
        CHECK(result.energy_gain.has_value() == !booked);
        CHECK(std::abs(scene.world.driven) < (booked ? 5 : 1e-12));  // 216 J there and back
        CHECK(scene.world.bodies[0]->mean_velocity().x() == doctest::Approx(2));
    }
}
