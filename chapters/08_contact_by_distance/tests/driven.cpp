#include "chapters/08_contact_by_distance/experiments/freed_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/hinged_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/pressed_soft.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/08_contact_by_distance/tests/resumed.hpp"
#include "common/experiments/run/run.hpp"
#include "common/scenes/scene_reader.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE("given motion: a cube rides on a piston as its table says")
{
    for (const double dt : {0.01, 0.004})
        CHECK(std::abs(piston(dt).error()) < 1e-3);
}

TEST_CASE("given motion: a block slides off a turntable at the speed that friction allows")
{
    CHECK(std::abs(turntable_slip(0.01).error()) < 0.01);
}

TEST_CASE("running surface: a block on a belt slides until it is as fast, and the drive pays for the heat")
{
    for (const double dt : {0.01, 0.003}) {
        const Conveyed conveyed = conveyor(dt);
        CHECK(std::abs(conveyed.slid.error()) < 3 * dt);
        CHECK(std::abs(conveyed.heat.error()) < 1e-9);
    }
}

TEST_CASE("outside load: a force pushes a puck by (F/m - mu g) t^2 / 2")
{
    for (const double dt : {0.01, 0.004})
        CHECK(std::abs(pushed_puck(dt).error()) < 1.5 * dt);  // symplectic Euler is half a step ahead
}

TEST_CASE(
    "held directions: a torque and a force on the rim turn a wheel by T t / I, and a slider keeps its momentum when hit")
{
    for (const double dt : {0.01, 0.004}) {
        CHECK(std::abs(torque_on_wheel(dt).error()) < 1e-9);
        CHECK(std::abs(hit_slider(dt).error()) < 1e-5);
    }
}

TEST_CASE("hinges: a bar swings with its period")
{
    for (const double dt : {0.01, 0.005})
        CHECK(std::abs(swinging_bar(dt).error()) < 2e-3);
}

TEST_CASE("hinges: a ball gives a door its angular momentum about the hinge")
{
    for (const double dt : {0.01, 0.004}) {
        // a body may be turned from its levers by 5 mrad
        CHECK(std::abs(hit_door(dt).speed.error()) < 2e-3);
        CHECK(std::abs(hit_door(dt).momentum.error()) < 2e-3);
    }
}

TEST_CASE("hinges: a crank moves a slider to where its corners are")
{
    for (const double dt : {0.01, 0.004}) {
        const AgainstFormula slider = slider_crank(dt);
        CHECK(std::abs(slider.measured - slider.formula) < 0.2 * dt);
    }
}

TEST_CASE("outside load: a puck on a spring turns where friction has taken its part")
{
    for (const double dt : {0.01, 0.004})
        CHECK(std::abs(puck_on_spring(dt).error()) < 0.5 * dt);
}

TEST_CASE("given motion: a pin in a slot moves a yoke to r cos(omega t)")
{
    for (const double dt : {0.01, 0.004}) {
        const AgainstFormula yoke = pin_in_slot(dt);
        CHECK(std::abs(yoke.measured - yoke.formula) < 2e-4);
    }
}

TEST_CASE("outside load: forces at two points of a soft bar turn it by T t^2 / (2 I)")
{
    for (const double dt : {0.01, 0.004})
        CHECK(std::abs(turned_by_two_forces(dt).error()) < 0.01 + 3 * dt);
}

TEST_CASE("freed nodes: a soft bar that is turned by 360 degrees and let go swings back, and gains nothing" *
          doctest::test_suite("long simulation"))
{
    const LetGo bar = twisted_and_let_go(0.01);
    CHECK(std::abs(bar.period.error()) < 0.05);
    CHECK(bar.most_held <= 1);
}

TEST_CASE(
    "freed nodes: turned by ten degrees, a bar of three cells across swings with the period of the formula" *
    doctest::test_suite("long simulation"))
{
    CHECK(std::abs(twisted_and_let_go(0.01, {10, 8, 3}).period.error()) < 0.01);
}

TEST_CASE("hinges: what a door's speed misses falls with the stiffness of springs, not with the step")
{
    const auto missed = [](double dt, double stiffness) { return hit_door(dt, stiffness).speed.error(); };
    CHECK(missed(0.000625, 400) / missed(0.000625, 1600) == doctest::Approx(4).epsilon(0.2));
    CHECK(missed(0.000625, 25) > 0.9 * missed(0.00125, 25));
    for (const double dt : {0.01, 0.005})  // what is left is that of its lever
        CHECK(std::abs(missed(dt, 25600)) < 2e-4);
}

TEST_CASE("moving sheets: a box over the border rides if its middle is over the sheet, and falls if not")
{
    for (const double dt : {0.01, 0.004})
        for (const double beyond : {-0.1, -0.03, 0.03})
            CHECK(rides_on_sheet(beyond, dt) == (beyond < 0));
}

TEST_CASE("moving sheets: a rigid sheet lies on a box and carries a ball")
{
    for (const double dt : {0.01, 0.004})
        CHECK(std::abs(sheet_on_box(dt).error()) < 1e-3);
}

TEST_CASE(
    "pressed soft bodies: without friction the plate feels the material's stress, and no element inverts")
{
    for (const ElasticLaw law : {ElasticLaw::corotated, ElasticLaw::neo_hookean}) {
        const PressedOutcome found = press_soft({.law = law, .height = 0.6, .dt = 0.02});
        CHECK(found.force == doctest::Approx(found.formula).epsilon(0.01));
        CHECK(found.inverted == 0);
        CHECK(found.unsolved == 0);
        CHECK(found.deepest_mm < 1);
    }
}

namespace {

/// A slider that its lock carries just on the ground, and a cube on it.
Scene slider_on_ground()
{
    return read_scene(R"({"name": "s", "dt": 0.01, "duration": 0.5, "planes": [{"name": "ground"}],
        "contact": {"friction": {"model": "mass_splitting"}}, "bodies": [
        {"name": "slider", "type": "rigid", "shape": {"box": {"size": [1, 1, 1]}}, "mass": 10, "position": [0, 0.5, 0],
         "velocity": [3, 0, 0], "locked": {"translation": ["y"], "rotation": ["x", "y", "z"]}},
        {"name": "top", "type": "rigid", "shape": {"box": {"size": [0.5, 0.5, 0.5]}}, "mass": 1, "position": [0, 1.25, 0],
         "velocity": [3, 0, 0]}]})",
                      "", "s.json", {});
}

/// A cube that comes to rest on a piston, under a force that ends.
Scene resting_on_piston()
{
    return read_scene(
        R"({"name": "s", "dt": 0.01, "duration": 0.5, "contact": {"friction": {"model": "mass_splitting"}},
        "bodies": [
        {"name": "piston", "type": "static", "shape": {"box": {"size": [1, 0.2, 1]}}, "motion": {"until": 0.6, "table": [
         {"time": -0.2, "velocity": [0.1, 0, 0]}, {"time": 0.3, "displacement": [0.1, 0.1, 0], "turn": {"axis": [0, 1, 0], "angle_deg": 40}}, {"time": 0.9}]}},
        {"name": "cube", "type": "rigid", "shape": {"box": {"size": [0.3, 0.3, 0.3]}}, "mass": 2, "position": [0, 0.4, 0],
         "forces": [{"table": [{"time": 0, "force": [3, 0, 0]}, {"time": 0.4, "torque": [0, 1, 0]}], "axes": "body"}]}]})",
        "", "s.json", {});
}

/// A block on a plate that begins to move at once, at a time that may lie within a step.
Scene jerked_plate(double begins)
{
    return read_scene(R"({"name": "s", "dt": 0.01, "duration": 0.5,
        "contact": {"friction": {"model": "mass_splitting", "mu_s": 0.5, "mu_d": 0.5}}, "bodies": [
        {"name": "plate", "type": "static", "shape": {"box": {"size": [6, 0.2, 1]}}, "position": [0, -0.1, 0], "motion": {"table": [
         {"time": )" + std::to_string(begins) +
                          R"(, "velocity": [1, 0, 0]}, {"time": 2, "displacement": [)" +
                          std::to_string(2 - begins) + R"(, 0, 0], "velocity": [1, 0, 0]}]}},
        {"name": "block", "type": "rigid", "shape": {"box": {"size": [0.4, 0.1, 0.4]}}, "mass": 2, "position": [0, 0.05, 0]}]})",
                      "", "s.json", {});
}

Solver solver_for(const ContactParameters& parameters) { return chapter08_solver(parameters); }

}  // namespace

TEST_CASE("held directions: what the ground does not carry slides along it, and carries what lies on it")
{
    Scene scene = slider_on_ground();
    run(scene, solver_for(scene.contact));
    for (const auto& body : scene.world.bodies)
        CHECK((body->mean_velocity() - Vec3(3, 0, 0)).norm() < 1e-6);
    CHECK(scene.world.bodies[1]->centre().y() == doctest::Approx(1.25).epsilon(1e-5));
}

TEST_CASE(
    "given motion: a plate that begins at once drags a block along, and its drive pays for speed and heat")
{
    for (const double begins : {0.0, 0.1, 0.1037}) {
        CAPTURE(begins);
        Scene scene = jerked_plate(begins);
        run(scene, solver_for(scene.contact));
        CHECK(scene.world.bodies[1]->mean_velocity().x() == doctest::Approx(1).epsilon(1e-6));
        const double lags = 1 / (2 * 0.5 * 9.81);  // v^2 / (2 mu g): the block's way behind the plate
        CHECK(scene.world.bodies[1]->centre().x() == doctest::Approx(0.5 - begins - lags).epsilon(0.03));
        CHECK(scene.world.driven == doctest::Approx(2).epsilon(0.02));  // m v^2: half of it is heat
    }
}

TEST_CASE("given motion and outside load: a run that is resumed goes on with the same numbers")
{
    CHECK(apart_when_resumed(resting_on_piston, solver_for, 30, 70) == 0);
}

TEST_CASE("materials: a block holds and slides by the coefficients of its pair of materials")
{
    const double angle = std::atan(0.5) * 180 / std::numbers::pi;
    for (const double dt : {0.01, 0.004}) {
        CHECK(materials_hold(angle - 0.3, dt));
        CHECK_FALSE(materials_hold(angle + 0.3, dt));
        CHECK(std::abs(slide_of_materials(30, dt).error()) < 0.01);
    }
}
