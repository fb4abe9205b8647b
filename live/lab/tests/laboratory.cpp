#include "live/laboratory.hpp"
#include "chapters/13_other_solvers/solver.hpp"
#include "common/input/input_error.hpp"
#include "common/input/json_document.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using laboratory::Laboratory;

namespace {

/// A cube of 2 kg a centimetre above the ground, or without weight.
std::string cube(const std::string& gravity = "[0, -9.81, 0]")
{
    return R"({"name": "cube", "dt": 0.01, "duration": 1, "gravity": )" + gravity +
           R"(, "planes": [{"name": "ground"}],
               "bodies": [{"name": "cube", "type": "rigid", "shape": {"box": {"size": [1, 1, 1]}}, "mass": 2, "position": [0, 0.51, 0]}]})";
}

void steps(Laboratory& lab, int count)
{
    for (int i = 0; i < count; ++i)
        lab.step();
}

}  // namespace

TEST_CASE("laboratory: a mistake in a scene's text is told with its place")
{
    CHECK_THROWS_WITH_AS(
        Laboratory(R"({"name": "x", "dt": -9, "duration": 1, "bodies": []})", "own.json", {}, "10"),
        doctest::Contains("own.json: /dt: expected a number from 1e-06 to 3600 [s]"), InputError);
    CHECK_THROWS_WITH_AS(Laboratory(cube(), "own.json", {}, "14"), doctest::Contains("14 has no solver"),
                         InputError);
    CHECK_THROWS_WITH_AS(Laboratory(cube(), "own.json", {}, "xpdb"), doctest::Contains("no method 'xpdb'"),
                         InputError);
}

TEST_CASE("laboratory: a scene that asks for exact contact runs under chapter 11 and says so under any other")
{
    std::string text = cube();
    text.insert(1, R"("contact": {"exact": true}, )");
    CHECK_THROWS_WITH_AS(Laboratory(text, "own.json", {}, "10"),
                         doctest::Contains("own.json: /contact/exact: the springs of chapter 10 give"),
                         InputError);
    Laboratory lab(text, "own.json", {}, "11");
    steps(lab, 40);
    CHECK(lab.numbers().depth < 1e-9);
}

TEST_CASE("laboratory: without a hand it steps as the chapter's solver does, to the last bit")
{
    for (const int chapter : {3, 6, 7, 10}) {
        CAPTURE(chapter);
        const std::string text = read_text_file(scene_file("tower"));
        Laboratory lab(text, "tower.json", {}, std::to_string(chapter)),
            again(text, "tower.json", {}, std::to_string(chapter));
        again.hold({1, 0, Vec3(0, 5, 0)});
        again.hold({});
        steps(lab, 20);
        steps(again, 20);
        CHECK(lab.scene().world.bodies.back()->positions_t0()[3] ==
              again.scene().world.bodies.back()->positions_t0()[3]);
        CHECK(lab.solver().name == "chapter " + std::to_string(chapter));
    }
}

TEST_CASE("laboratory: a hand brings the face that it holds to where it points")
{
    for (const char* const solver : {"1", "6", "10", "soft_step", "avbd"}) {
        CAPTURE(solver);
        Laboratory lab(cube("[0, 0, 0]"), "cube.json", {}, solver);
        const Vec3 target(0.4, 3, -0.2);
        lab.hold({0, 0, target});
        steps(lab, 600);
        const Body& body = *lab.scene().world.bodies.front();
        Vec3 middle = Vec3::Zero();
        for (const int vertex : body.surface().faces().front())
            middle += body.positions_t0()[static_cast<std::size_t>(vertex)] / 3;
        CHECK((middle - target).norm() < 0.1);  // of 2.9 m; the body still swings about it
    }
}

TEST_CASE("laboratory: in the hand's first step a body at rest gains k d dt / (1 + c dt + k dt^2) of speed")
{
    using Hand = laboratory::Hand;
    Laboratory lab(cube("[0, 0, 0]"), "cube.json", {}, "10");
    const Body& body = *lab.scene().world.bodies.front();
    Vec3 middle = Vec3::Zero();
    for (const int vertex : body.surface().faces().front())
        middle += body.positions_t0()[static_cast<std::size_t>(vertex)] / 3;
    lab.hold({0, 0, middle + Vec3(0, 0.5, 0)});
    lab.step();
    const double dt = 0.01;
    CHECK(body.mean_velocity().y() ==
          doctest::Approx(Hand::stiffness * 0.5 * dt / (1 + Hand::damping * dt + Hand::stiffness * dt * dt)));
}

TEST_CASE("laboratory: a resting cube has four pairs that carry its weight, and tells since when")
{
    Laboratory lab(cube(), "cube.json", {}, "10");
    steps(lab, 100);
    constexpr std::size_t kind = 0, point_y = 6, depth = 11, impulse_y = 13, since = 23;  // of its numbers
    double impulse = 0;
    for (const PairNumbers& pair : lab.pairs()) {
        impulse += pair[impulse_y];
        CHECK(pair[kind] == static_cast<double>(ContactKind::vertex_plane));
        CHECK(pair[since] < 90);
        CHECK(pair[point_y] == doctest::Approx(pair[depth]));
    }
    const StepNumbers numbers = lab.numbers();
    CHECK(numbers.pairs == 4);
    CHECK(impulse == doctest::Approx(2 * 9.81 * 0.01).epsilon(1e-3));
    CHECK(numbers.step == 100);
    CHECK(numbers.gravitational == doctest::Approx(2 * 9.81 * 0.5).epsilon(1e-3));
}

TEST_CASE("laboratory: the solvers of part I count responses, those of part II Newton's steps as well")
{
    Laboratory first(cube(), "cube.json", {}, "3"), second(cube(), "cube.json", {}, "7");
    steps(first, 30);
    steps(second, 30);
    CHECK(first.numbers().work.responses > 0);
    CHECK(first.numbers().work.newton_steps == 0);
    CHECK(second.numbers().work.newton_steps > 0);
    CHECK(second.numbers().work.attempts == 1);
}

TEST_CASE(
    "laboratory: under each method of chapter 13 a cube comes to rest on the ground, by the method's name")
{
    for (const OtherMethod& method : other_methods()) {
        CAPTURE(method.name);
        Laboratory lab(cube(), "cube.json", {}, method.name);
        steps(lab, 200);
        const Body& body = *lab.scene().world.bodies.front();
        CHECK(lab.numbers().pairs == 4);
        CHECK(std::abs(body.centre().y() - 0.5) < 5e-3);  // the slop of two of them is 5 mm
        CHECK(body.mean_velocity().norm() < 1e-3);
    }
}
