#include "chapters/08_contact_by_distance/experiments/bouncing_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/08_contact_by_distance/tests/resumed.hpp"
#include "common/scenes/scene_reader.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE("bouncing: the first bounce keeps e^2 of the height, within 2 percent, on a plane and on triangles")
{
    for (const Floor floor : {Floor::plane, Floor::triangles})
        for (const double dt : {0.01, 0.005})
            for (const double e : {0.25, 0.5, 0.75, 1.0}) {
                CAPTURE(dt);
                CAPTURE(e);
                CHECK(kept_height(e, floor, dt) == doctest::Approx(e * e).epsilon(0.002));
            }
    CHECK(std::abs(kept_height(0, Floor::plane, 0.01)) < 1e-4);
}

TEST_CASE("bouncing: a cradle of five balls hands its momentum on, without gaps and with them")
{
    for (const double gap : {0.0, 1e-4, 1e-3, 1e-2}) {
        const std::vector<double> end = cradle(1, gap, 0.01).velocities;
        CAPTURE(gap);
        for (std::size_t ball = 0; ball < end.size(); ++ball)
            CHECK(std::abs(end[ball] - (ball == 4 ? 1 : 0)) < 1e-3);
    }
}

TEST_CASE("bouncing: a cradle that hangs without gaps hands its speed on, and no step ends badly")
{
    for (const double dt : {0.01, 0.005}) {
        const HangingCradle end = hanging_cradle(0, dt);
        CAPTURE(dt);
        CHECK(end.ended_badly == 0);
        CHECK(end.handed_on == doctest::Approx(1).epsilon(0.02));
    }
}

TEST_CASE("bouncing: balls with gaps meet one after the other, each pair with its own (1 + e) / 2")
{
    for (const double e : {0.5, 0.75}) {
        const Cradle end = cradle(e, 0.01, 0.005);
        CHECK(end.velocities[4] == doctest::Approx(std::pow((1 + e) / 2, 4)).epsilon(1e-3));
    }
}

TEST_CASE("bouncing: a cube on its corner gains nothing, and keeps its energy without friction at e = 1")
{
    for (const double e : {0.5, 1.0})
        for (const double mu : {0.0, 0.3})
            CHECK(cube_on_corner(e, mu, 0.01, 2).most_gained < 1e-9);
    CHECK(cube_on_corner(1, 0, 0.01, 2).left > 0.8);
}

TEST_CASE("bouncing: two soft cubes gain nothing, whatever their coefficient" *
          doctest::test_suite("long simulation"))
{
    for (const char* const response : {"implicit", "lumped"})
        for (const double e : {0.0, 0.5, 1.0})
            CHECK(soft_cubes(e, 0.005, response).most_gained < 1e-3);
}

TEST_CASE("bouncing: a stack of ten comes to rest with e = 0.9")
{
    const double rest = rest_of_stack(0.9, 0.01);
    CHECK(rest > 0.1);
    CHECK(rest < 5);
}

TEST_CASE(
    "bouncing: friction takes mu (1 + e) of the velocity towards the ground, and no more than stops the slide")
{
    for (const double e : {0.5, 1.0})
        for (const double mu : {0.0, 0.1, 0.3, 0.9}) {
            const ObliqueBounce end = oblique_bounce(e, mu, 0.01);
            CAPTURE(e);
            CAPTURE(mu);
            CHECK(end.along == doctest::Approx(std::max(0.0, 1 - mu * (1 + e))).epsilon(1e-3));
            CHECK(end.up == doctest::Approx(e).epsilon(1e-3));
        }
}

namespace {

/// A ball on a bat that comes up, or between two materials; without weight.
Scene batted(const std::string& change)
{
    return read_scene(
        R"({"name": "b", "dt": 0.01, "duration": 1, "gravity": [0, 0, 0], "contact": {"restitution": 1},
        "bodies": [
        {"name": "bat", "type": "static", "shape": {"box": {"size": [1, 0.2, 1]}}, "position": [0, -0.3, 0],
         "motion": {"velocity": [0, 2, 0]}},
        {"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.1}}, "mass": 3, "position": [0, 0.1, 0],
         "velocity": [0, -1, 0]}]})",
        change, "b.json", {});
}

void run_steps(Scene& scene, int steps)
{
    const Solver solver = chapter08_solver(scene.contact);
    Contacts contacts;
    for (int step = 0; step < steps; ++step)
        advance(scene.world, contacts, solver, scene.dt);
}

}  // namespace

TEST_CASE(
    "bouncing: a bat that moves as given sends a ball back by its own velocity twice, and books its work")
{
    Scene scene = batted("");
    run_steps(scene, 30);
    CHECK(scene.world.bodies[1]->mean_velocity().y() == doctest::Approx(2 * 2 + 1).epsilon(1e-6));
    CHECK(scene.world.driven == doctest::Approx(3.0 / 2 * (25 - 1)).epsilon(1e-6));
    CHECK(scene.world.thrown_away == 0);
}

TEST_CASE("bouncing: a pair of materials has its own coefficient")
{
    Scene scene =
        batted(R"({"materials": [{"name": "clay", "restitution": 0}, {"name": "steel", "restitution": 0.9}],
        "material_pairs": [{"between": ["steel", "clay"], "restitution": 0.4}],
        "/bodies/bat/material": "steel", "/bodies/ball/material": "clay"})");
    run_steps(scene, 30);
    CHECK(scene.world.bodies[1]->mean_velocity().y() == doctest::Approx(2 + 0.4 * 3).epsilon(1e-6));
}

TEST_CASE("bouncing: momentum is kept where nothing acts from outside, and a run goes on as it was saved")
{
    const auto make = [] { return cradle_scene(0.7, 1e-3, 0.01); };
    Scene scene = make();
    run_steps(scene, 40);
    Vec3 momentum = Vec3::Zero();
    for (const auto& body : scene.world.bodies)
        momentum += body->linear_momentum();
    CHECK(std::abs(momentum.x() - 1) < 1e-12);
    const auto solver_for = [](const ContactParameters& parameters) { return chapter08_solver(parameters); };
    CHECK(apart_when_resumed(make, solver_for, 21, 23) == 0);
}

namespace {

/// Balls that fall on the ground side by side, and a stack between them: an island each.
std::vector<double> state_of_islands(const char* threads)
{
    setenv("ENDURING_THREADS", threads, 1);
    std::string bodies;
    for (int ball = 0; ball < 4; ++ball)
        bodies += R"({"name": "ball )" + std::to_string(ball) +
                  R"(", "type": "rigid", "shape": {"sphere": {"radius": 0.1}}, "mass": 1, "position": [)" +
                  std::to_string(ball) + ", 0." + std::to_string(2 + ball) +
                  R"(, 0], "angular_velocity": [1, 2, 3]},)";
    Scene scene = read_scene(
        R"({"name": "i", "dt": 0.01, "duration": 1, "planes": [{"name": "ground"}],
        "contact": {"restitution": 0.7, "friction": {"model": "mass_splitting"}}, "bodies": [)" +
            bodies +
            R"({"name": "low", "type": "rigid", "shape": {"box": {"size": [0.3, 0.3, 0.3]}}, "mass": 1, "position": [0.5, 0.15, 2]},
            {"name": "high", "type": "rigid", "shape": {"box": {"size": [0.3, 0.3, 0.3]}}, "mass": 1, "position": [0.5, 0.6, 2]}]})",
        "", "i.json", {});
    run_steps(scene, 60);
    unsetenv("ENDURING_THREADS");
    std::vector<double> numbers;
    for (const auto& body : scene.world.bodies) {
        const std::vector<double> own = state_of(*body);
        numbers.insert(numbers.end(), own.begin(), own.end());
    }
    return numbers;
}

/// A ball that begins two millimetres inside the ground, after half a second.
std::vector<double> begun_inside(double e)
{
    Scene scene = read_scene(
        R"({"name": "d", "dt": 0.01, "duration": 1, "planes": [{"name": "ground"}], "contact": {"restitution": )" +
            std::to_string(e) + R"(}, "bodies": [
        {"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.1}}, "mass": 3, "position": [0, 0.098, 0]}]})",
        "", "d.json", {});
    run_steps(scene, 50);
    return state_of(*scene.world.bodies[0]);
}

}  // namespace

TEST_CASE("bouncing: two threads give the bytes of one")
{
    CHECK(state_of_islands("2") == state_of_islands("1"));
}

TEST_CASE("bouncing: what begins inside the ground does not bounce, whatever its coefficient")
{
    const std::vector<double> without = begun_inside(0);
    CHECK(begun_inside(1) == without);
    CHECK(begun_inside(0.5) == without);
}
