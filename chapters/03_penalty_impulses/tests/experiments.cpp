#include "chapters/03_penalty_impulses/experiments/bar_drop.hpp"
#include "chapters/03_penalty_impulses/experiments/jitter.hpp"
#include "chapters/03_penalty_impulses/experiments/scene_change.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/run/elements_of.hpp"
#include "common/experiments/run/run.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace enduring;
using namespace enduring::chapter03;

namespace {

/// The scene after a while, with the contacts alive then.
struct Later {
    Scene scene;
    RunResult result;
    double highest_energy = 0, first_energy = 0;
    int max_inverted = 0;
};

Later later(const std::string& name, double time, const std::string& patch = "")
{
    Later it{load_scene(scene_file(name), patch), {}};
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        double energy = 0;
        int inverted = 0;
        for (const auto& body : world.bodies) {
            energy += body->energy(world.gravity).total();
            inverted += body->inverted_elements();
        }
        if (world.step == 0)
            it.first_energy = energy;
        it.highest_energy = std::max(it.highest_energy, energy);
        it.max_inverted = std::max(it.max_inverted, inverted);
    });
    RunLimits limits = failure_on_purpose();  // the lumped bunny explodes, and a test says so
    limits.steps = static_cast<int>(time / it.scene.dt + 0.5);
    it.result = run(it.scene, chapter03_solver(it.scene.contact), {&watch}, limits);
    return it;
}

void check_picture(const Later& it, const std::string& name)
{
    Renderer renderer(640, 420);
    Stage stage = stage_of(it.scene.world, it.scene);
    mark_contacts(stage, it.scene.world, it.result.contacts);
    const ReferenceCheck check = check_reference_picture(renderer.draw(stage),
                                                         "03_penalty_impulses/" + name + ".png");
    CHECK_MESSAGE(check.passed, check.message);
}

#ifdef __SANITIZE_ADDRESS__
const std::vector<double> few_turns{46};  // sanitizers look for other faults, at ten times the cost
#else
const std::vector<double> few_turns{44, 45, 46};
#endif

double median_jitter(PenaltyMethod method, double dt, double stiffness = 5000)
{
    std::vector<double> jitters;
    for (const double turn : few_turns)
        jitters.push_back(jitter_at_rest(drop_bar(scene_file("bar_on_cube"), {method, dt, stiffness, turn})));
    return median(jitters);
}

}  // namespace

TEST_CASE(
    "jitter: an alternation of height a counts as a, a constant as nothing, a slow swing as next to nothing")
{
    std::vector<double> alternating, constant(50, 7.0), swing;
    for (int i = 0; i < 50; ++i) {
        alternating.push_back(100 + (i % 2 ? 3 : -3));
        swing.push_back(100 + 3 * std::sin(0.1 * i));
    }
    CHECK(jitter(alternating, 10) == doctest::Approx(0.3));
    CHECK(jitter(constant, 10) == 0);
    CHECK(jitter(swing, 10) < 0.001);
}

TEST_CASE("bar on cube: at rest the cube carries the bar's weight")
{
    const BarRecord record = drop_bar(scene_file("bar_on_cube"), {});
    double force = 0;
    int steps = 0;
    for (std::size_t i = 0; i < record.time.size(); ++i)
        if (record.time[i] >= at_rest_from) {
            force += record.force[i];
            ++steps;
        }
    CHECK(force / steps == doctest::Approx(record.weight).epsilon(0.03));
}

TEST_CASE(
    "bar on cube: with quadratic elements the continuous force lies still at dt = 0.008 s, where the discrete one jitters" *
    doctest::test_suite("long simulation"))
{
    CHECK(elements_of(load_bar_scene(scene_file("bar_on_cube"), {}).world, "bar") == "48 quadratic elements");
    CHECK(median_jitter(PenaltyMethod::continuous, 0.008) < 0.003);
    CHECK(median_jitter(PenaltyMethod::discrete, 0.008) > 0.003);
    CHECK(median_jitter(PenaltyMethod::discrete, 0.0055) < 0.003);
    CHECK(median_jitter(PenaltyMethod::continuous, 0.012) > 0.003);
}

TEST_CASE(
    "bar on cube: along a constant k dt^2 the continuous force lies still, and the bar one to two times as deep as with the discrete one" *
    doctest::test_suite("long simulation"))
{
    for (const double dt : {0.005, 0.007, 0.010}) {
        CAPTURE(dt);
        CHECK(median_jitter(PenaltyMethod::continuous, dt, stiffness_between_limits(dt)) < 0.003);
        const double ratio = depths_between_limits(scene_file("bar_on_cube"), dt).ratio();
        CHECK(ratio > 1);
        CHECK(ratio < 2.1);
    }
}

TEST_CASE("jitter: a bar that nothing carries does not count as smooth")
{
    BarRecord record;
    record.weight = 800;
    for (int i = 0; i < 100; ++i) {
        record.time.push_back(at_rest_from + 0.01 * i);
        record.force.push_back(0);
    }
    CHECK(jitter_at_rest(record) == 1);
}

TEST_CASE("bar on cube: the stiffer the pairs, the less deep lies the bar" *
          doctest::test_suite("long simulation"))
{
    double last = 1;
    for (const double stiffness : {2500.0, 5000.0, 10000.0}) {
        const double depth =
            depth_at_rest(drop_bar(scene_file("bar_on_cube"), {PenaltyMethod::continuous, 0.005, stiffness}));
        CHECK(depth < 0.8 * last);
        last = depth;
    }
}

TEST_CASE("bar on cube: the first impact is as in its reference picture")
{
    check_picture(later("bar_on_cube", 0.4), "bar_on_cube");
}

TEST_CASE("bunny in the bowl: it falls in, adds no energy and inverts no element")
{
    const Later it = later("bunny_bowl", 1.0);
    CHECK(it.highest_energy <= 1.001 * it.first_energy);
    CHECK(it.max_inverted == 0);
    const Body &bowl = body_named(it.scene.world, "bowl"), &bunny = body_named(it.scene.world, "bunny");
    const auto higher = [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); };
    const auto rim = std::max_element(bowl.positions_t0().begin(), bowl.positions_t0().end(), higher)->y();
    const auto feet = std::min_element(bunny.positions_t0().begin(), bunny.positions_t0().end(), higher)->y();
    const auto floor = std::min_element(bowl.positions_t0().begin(), bowl.positions_t0().end(), higher)->y();
    CHECK(feet < rim);
    CHECK(feet > floor);
}

TEST_CASE(
    "bunny in the bowl: in both scenes a bowl as heavy as bowl and bunny rests less than 5 mm deep in the ground, far below the limit of the step")
{
    for (const std::string name : {"bunny_bowl", "bunny_at_rest"}) {
        CAPTURE(name);
        nlohmann::json bowl = bodies_of(scene_file(name))[0];
        REQUIRE(bowl["name"] == "bowl");
        const double alone = bowl["mass"];
        bowl["mass"] = alone + 30;
        const Later it = later(name, 3.0, nlohmann::json{{"bodies", {bowl}}}.dump());
        PenetrationProbe depths(it.scene.contact.stiffness);
        depths.observe(it.scene.world, it.result.contacts, it.scene.dt);
        const double in_ground = std::get<double>(depths.table().rows().back()[8]);
        CHECK(in_ground > 0);
        CHECK(in_ground < 0.005);
        const double nk = static_cast<double>(it.result.contacts.size()) *
                          it.scene.world.planes[0].stiffness.value_or(it.scene.contact.stiffness);
        CHECK(nk * it.scene.dt * it.scene.dt / alone < 1);  // the limit is 2
    }
}

TEST_CASE("bunny in the bowl: the moment before the first bounce is as in its reference picture" *
          doctest::test_suite("long simulation"))
{
    check_picture(later("bunny_bowl", 0.5), "bunny_bowl");
}

TEST_CASE("hooked: a cube that slides without friction over triangles stops, and on a plane it does not")
{
    const Later triangles = later("hooked", 1.5);
    const Body& cube = body_named(triangles.scene.world, "cube");
    const double x = cube.positions_t0()[0].x() + 0.25;      // its first vertex began at -0.25
    CHECK(cube.linear_momentum().x() / cube.mass() < 0.75);  // it began with 1.5 m/s
    CHECK(x < 1.0);                                          // and would have come 2.25 m far

    const Later plane = later("hooked", 1.5,
                              R"({"planes": [{"name": "ground"}], "bodies": [{"name": "cube", "type": "rigid",
        "shape": {"box": {"size": [0.5, 0.5, 0.5]}}, "mass": 20, "position": [0, 0.255, 0.03], "velocity": [1.5, 0, 0]}]})");
    const Body& free = body_named(plane.scene.world, "cube");
    CHECK(free.linear_momentum().x() / free.mass() == doctest::Approx(1.5).epsilon(1e-9));
}
