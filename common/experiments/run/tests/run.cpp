#include "common/experiments/run/run.hpp"
#include "common/experiments/run/centre_of_mass.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/input/input_error.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/tests/triangle_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <iostream>
#include <sstream>

using namespace enduring;

namespace {

double number(const Table& table, std::size_t row, std::size_t column)
{
    const Cell& cell = table.rows().at(row).at(column);
    return std::holds_alternative<long>(cell) ? static_cast<double>(std::get<long>(cell))
                                              : std::get<double>(cell);
}

/// Two triangles, the upper one moving down at 1 m/s, 0.25 m apart.
Scene two_sheets()
{
    Scene scene;
    scene.name = "two sheets";
    scene.dt = 0.5;
    scene.duration = 1.5;
    scene.world.gravity.setZero();
    scene.world.bodies.push_back(triangle("upper", 0.25, {0, -1, 0}));
    scene.world.bodies.push_back(triangle("lower"));
    return scene;
}

Contact vertex_on_face(int vertex)
{
    return {ContactKind::vertex_face, 0, 1, vertex, 0, {vertex, 0, 1, 2}, {1, -0.5, -0.25, -0.25}};
}

}  // namespace

TEST_CASE("run: as many steps as the duration asks for, and the probes look once more than that")
{
    Scene scene = two_sheets();
    MotionProbe motion("upper");
    int looks = 0;
    WatchProbe watch([&](const World&, const Contacts&, double) { ++looks; });
    const RunResult result = run(scene, {}, {&motion, &watch});
    CHECK(result.steps == 3);
    CHECK(looks == 4);
    REQUIRE(motion.table().rows().size() == 4);
    CHECK(number(motion.table(), 3, 0) == doctest::Approx(1.5));
    CHECK(number(motion.table(), 3, 2) == doctest::Approx(0.25 - 1.5));
    CHECK(number(motion.table(), 3, 5) == doctest::Approx(-1));
    CHECK_THROWS_WITH_AS(MotionProbe("middle").observe(scene.world, {}, 0.5),
                         "the scene has no body \"middle\"; it has upper, lower", InputError);
}

TEST_CASE(
    "run: a probe of motion tells place and velocity of one point, the centre of mass, of rigid and of soft bodies")
{
    Scene scene = read_scene(R"({"name": "flying", "dt": 0.01, "duration": 0.3, "bodies": [
        {"name": "bowl", "type": "rigid", "mass": 2, "velocity": [1, 2, 0], "angular_velocity": [3, 0, 9], "position": [5, 0, 0],
         "shape": {"bowl": {"inner_radius": 0.3, "thickness": 0.1, "rim_angle_deg": 90, "foot_radius": 0.1, "segments_around": 12,
                            "segments_along": 4, "segments_rim": 2}}},
        {"name": "arm", "type": "deformable", "young": 1e5, "poisson": 0.3, "density": 1000, "impulse_response": "implicit",
         "shape": {"bar": {"size": [1, 0.2, 0.2], "cells": [3, 1, 1]}}, "fixed": {"max": [-0.49, 9, 9]}}]})",
                             "", "flying.json", {});
    const double at_once = centre_of_mass(*scene.world.bodies[0]).y();
    CHECK(std::abs(scene.world.bodies[0]->centre().y() - at_once) >
          0.005);  // another point than the mean vertex
    MotionProbe bowl("bowl"), arm("arm");
    run(scene, {}, {&bowl, &arm});
    for (const MotionProbe* probe : {&bowl, &arm}) {
        const Table& table = probe->table();
        for (std::size_t row = 1; row < table.rows().size(); ++row)
            for (std::size_t axis = 1; axis <= 3; ++axis) {
                CAPTURE(row);
                CAPTURE(axis);
                const double moved = number(table, row, axis) - number(table, row - 1, axis);
                CHECK(std::abs(moved / 0.01 - number(table, row, axis + 3)) < 1e-9);
            }
    }
    CHECK(number(bowl.table(), 30, 2) == doctest::Approx(at_once + 0.6 - 9.81 * 1e-4 * 30 * 31 / 2));
}

TEST_CASE("run: duration / dt steps despite rounding, and one more when it is not whole")
{
    Scene scene;
    scene.dt = 0.1;
    scene.duration = 0.3;  // 0.3 / 0.1 is 2.9999999999999996
    CHECK(step_count(scene) == 3);
    scene.dt = 0.001;
    scene.duration = 4.001;  // 4.001 / 0.001 is 4001.0000000000005
    CHECK(step_count(scene) == 4001);
    scene.dt = 0.1;
    scene.duration = 0.31;
    CHECK(step_count(scene) == 4);
    scene.dt = 1.0 / 3;
    scene.duration = 2;
    CHECK(step_count(scene) == 6);
}

TEST_CASE("run: steps that end badly even in their shortest parts are told, with their number")
{
    for (const bool pushed : {false, true}) {
        Scene scene = two_sheets();
        scene.name = pushed ? "pushed sheets" : "sheets";
        Solver solver;
        solver.name = "halving";
        solver.max_halvings = 1;
        solver.append(StepStage::refresh, "push", [pushed](World& world, Contacts&, double) {
            if (pushed && world.step == 1)
                world.attempt.trouble = StepTrouble::unsolved;
        });
        std::ostringstream told;
        std::streambuf* const before = std::cerr.rdbuf(told.rdbuf());
        run(scene, solver, {});
        std::cerr.rdbuf(before);
        const bool warned = told.str().find(
                                "pushed sheets, halving: 2 steps or parts of steps were not solved, "
                                "turned a body too far or gained energy, and could not be halved "
                                "any more; 1 attempts were repeated") != std::string::npos;
        CHECK(warned == pushed);
    }
}

TEST_CASE("run: a limit or a stop ends it early")
{
    Scene scene = two_sheets();
    CHECK(run(scene, {}, {}, {2, {}}).steps == 2);
    Scene again = two_sheets();
    CHECK(run(again, {}, {}, {{}, [](const World& world, const Contacts&) { return world.time > 0.4; }})
              .steps == 1);
}

TEST_CASE("run: a scene that asks for exact contact does not begin under a solver whose springs give")
{
    Scene scene = two_sheets();
    scene.asks_exact = "sheets.json: /contact/exact";
    Solver solver;
    CHECK_THROWS_AS(run(scene, solver, {}), InputError);
    CHECK(scene.world.step == 0);
    solver.exact = true;
    CHECK_NOTHROW(run(scene, solver, {}, {1, {}}));
}

TEST_CASE(
    "run: a stiffness that the step cannot bear is told under a solver that takes it, and under no other")
{
    const auto told_under = [](bool finds_stiffness, const std::string& warning) {
        Scene scene = two_sheets();
        scene.stiffness_warning = warning;  // each sentence is told once only
        Solver solver;
        solver.finds_stiffness = finds_stiffness;
        std::ostringstream told;
        std::streambuf* const before = std::cerr.rdbuf(told.rdbuf());
        run(scene, solver, {}, {1, {}});
        std::cerr.rdbuf(before);
        return told.str();
    };
    CHECK(told_under(false, "too stiff for one").find("too stiff for one") != std::string::npos);
    CHECK(told_under(true, "too stiff for the other").empty());
}

TEST_CASE("probes: energy and momentum of point masses are the textbook's")
{
    Scene scene = two_sheets();
    scene.world.gravity = {0, -10, 0};
    EnergyProbe energy;
    MomentumProbe momentum;
    energy.observe(scene.world, {}, 0.5);
    momentum.observe(scene.world, {}, 0.5);
    CHECK(number(energy.table(), 0, 1) == doctest::Approx(1.5));  // 3 kg at 1 m/s
    CHECK(number(energy.table(), 0, 2) == doctest::Approx(7.5));  // 3 kg at 0.25 m
    CHECK(number(energy.table(), 0, 4) == doctest::Approx(9.0));
    CHECK(number(momentum.table(), 0, 2) == doctest::Approx(-3));
    // sum of x cross m v over (0,0), (z=1), (x=1) at v = -y: (z, 0, -x) each.
    CHECK(number(momentum.table(), 0, 4) == doctest::Approx(1));
    CHECK(number(momentum.table(), 0, 6) == doctest::Approx(-1));
}

TEST_CASE("probes: penetration sums the depths inside, and bounds the step by the reduced mass")
{
    Scene scene = two_sheets();
    scene.world.planes.push_back({"ground", {0, 0.3, 0}, Vec3::UnitY()});
    Contacts contacts{vertex_on_face(0), vertex_on_face(1)};
    contacts.push_back({ContactKind::vertex_plane, 0, 0, 2, -1, {2, -1, -1, -1}, {1, 0, 0, 0}});
    PenetrationProbe probe(100);
    probe.observe(scene.world, contacts, 0.5);
    // Above the lower sheet by 0.25, below the ground by 0.05.
    CHECK(number(probe.table(), 0, 1) == 3);
    CHECK(number(probe.table(), 0, 2) == 1);
    CHECK(number(probe.table(), 0, 3) == doctest::Approx(0.05));
    CHECK(number(probe.table(), 0, 5) == doctest::Approx(100));
    CHECK(number(probe.table(), 0, 6) == doctest::Approx(std::sqrt(2 * 3.0 / 100)));

    run(scene, {}, {}, {1, {}});  // now 0.25 below the lower sheet, 0.55 below the ground
    probe.observe(scene.world, contacts, 0.5);
    CHECK(number(probe.table(), 1, 2) == 3);
    CHECK(number(probe.table(), 1, 3) == doctest::Approx(0.25 + 0.25 + 0.55));
    CHECK(number(probe.table(), 1, 4) == doctest::Approx(0.55));
    CHECK(number(probe.table(), 1, 5) == doctest::Approx(200));
    // two 3 kg bodies: reduced 1.5 kg
    CHECK(number(probe.table(), 1, 6) == doctest::Approx(std::sqrt(2 * 1.5 / 200)));
    CHECK(number(probe.table(), 1, 7) == 0.5);
    CHECK(number(probe.table(), 1, 8) == doctest::Approx(0.55));

    scene.world.planes[0].stiffness = 5000;  // on it, and on it alone: 3 kg
    probe.observe(scene.world, contacts, 0.5);
    CHECK(number(probe.table(), 2, 4) == doctest::Approx(0.55));
    CHECK(number(probe.table(), 2, 5) == doctest::Approx(5000));
    CHECK(number(probe.table(), 2, 6) == doctest::Approx(std::sqrt(2 * 3.0 / 5000)));

    contacts[2].hold(true);  // takes no impulse: neither deep nor stiff
    probe.observe(scene.world, contacts, 0.5);
    CHECK(number(probe.table(), 3, 1) == 3);
    CHECK(number(probe.table(), 3, 2) == 2);
    CHECK(number(probe.table(), 3, 4) == doctest::Approx(0.25));
    CHECK(number(probe.table(), 3, 8) == 0);
}

TEST_CASE("probes: the force is the impulse over dt, equal and opposite from the other side")
{
    Scene scene = two_sheets();
    Contacts contacts{vertex_on_face(0), vertex_on_face(1)};
    contacts[0].impulse = {0, 2, 0};
    contacts[1].impulse = {1, 0.5, 0};
    ForceProbe on_upper("upper", "lower"), on_lower("lower", "upper");
    on_upper.observe(scene.world, contacts, 0.5);
    on_lower.observe(scene.world, contacts, 0.5);
    for (std::size_t i = 1; i <= 3; ++i)
        CHECK(number(on_upper.table(), 0, i) == -number(on_lower.table(), 0, i));
    CHECK(number(on_upper.table(), 0, 1) == doctest::Approx(2));
    CHECK(number(on_upper.table(), 0, 2) == doctest::Approx(5));
    CHECK(number(on_upper.table(), 0, 4) == 2);
    CHECK_THROWS_AS(ForceProbe("upper", "ground").observe(scene.world, contacts, 0.5), InputError);
    CHECK_THROWS_AS(ForceProbe("nobody", "lower").observe(scene.world, contacts, 0.5), InputError);
}

TEST_CASE("timings: what the probes take between two steps belongs to no pass")
{
    Scene scene = two_sheets();
    const auto dawdle = [](double seconds) {
        for (const double begin = processor_seconds(); processor_seconds() - begin < seconds;) {}
    };
    WatchProbe slow([&](const World&, const Contacts&, double) { dawdle(0.1); });
    const Pass slow_pass{"slow pass", [&](World&, Contacts&, double) { dawdle(0.01); }};
    const RunResult result = run(scene, {"slow", {slow_pass}, {}, {}}, {&slow});
    CHECK(result.timings.of("slow pass") >= 0.03);
    CHECK(result.timings.total() < 0.1);
}

TEST_CASE("timings: passes keep the order of their first run, and add up")
{
    Timings timings;
    timings.add("predict", 0.25);
    timings.add("detect", 0.5);
    timings.add("predict", 0.25);
    CHECK(timings.total() == doctest::Approx(1));
    CHECK(timings.of("predict") == doctest::Approx(0.5));
    CHECK(timings.of("respond") == 0);
    const Table table = timings.table(2.0, 4);
    REQUIRE(table.rows().size() == 4);
    CHECK(std::get<std::string>(table.rows()[0][0]) == "predict");
    CHECK(number(table, 0, 1) == 2);
    CHECK(number(table, 1, 3) == doctest::Approx(0.5));
    CHECK(number(table, 1, 4) == doctest::Approx(125));
    CHECK(number(table, 3, 3) == doctest::Approx(2));
}
