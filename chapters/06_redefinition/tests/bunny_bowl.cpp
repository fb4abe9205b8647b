#include "chapters/06_redefinition/experiments/inverted_elements.hpp"
#include "chapters/06_redefinition/experiments/stage_clock.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/experiments/run/probes.hpp"
#include "common/experiments/run/run.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

namespace {

const char* coarse = R"({"/bodies/bunny/shape/file": "bunny_363.msh"})";

double kinetic(const World& world)
{
    double sum = 0;
    for (const auto& body : world.bodies)
        sum += body->energy(world.gravity).kinetic;
    return sum;
}

}  // namespace

TEST_CASE(
    "bunny in the bowl: with friction and redefinition it comes to rest, within 6 s and to 0.1 % of the impact's kinetic energy" *
    doctest::test_suite("long simulation"))
{
    Scene scene = load_scene(scene_file("bunny_at_rest"), coarse);
    double before_touch = 0;
    bool touched = false;
    int max_inverted = 0;
    WatchProbe watch([&](const World& world, const Contacts& contacts, double) {
        touched = touched || std::any_of(contacts.begin(), contacts.end(),
                                         [](const Contact& c) { return !c.on_plane(); });
        if (!touched)
            before_touch = kinetic(world);
        max_inverted = std::max(max_inverted, chapter06::count_inverted(world));
    });
    PenetrationProbe depths(scene.contact.stiffness);
    const RunResult result = run(scene, chapter06_solver(scene.contact), {&watch, &depths});
    CHECK(before_touch > 200);
    CHECK(kinetic(scene.world) < 0.001 * before_touch);
    CHECK(result.contacts.size() > 50);  // it lies in the bowl, and has not fallen through
    CHECK(max_inverted <= 3);
    // the bowl stands on the ground, not in it
    CHECK(std::get<double>(depths.table().rows().back()[8]) < 0.005);
}

TEST_CASE(
    "bunny in the bowl: at the impact the lumped response turns elements inside out, and the implicit one fewer")
{
    int inverted[2] = {};
    for (const bool implicit : {false, true}) {
        Scene scene = load_scene(scene_file("bunny_at_rest"),
                                 implicit ? coarse : R"({"/bodies/bunny/shape/file": "bunny_363.msh",
            "/bodies/bunny/impulse_response": "lumped"})");
        WatchProbe watch([&](const World& world, const Contacts&, double) {
            inverted[implicit] = std::max(inverted[implicit], chapter06::count_inverted(world));
        });
        run(scene, chapter06_solver(scene.contact), {&watch}, {.steps = 56, .may_gain_energy = !implicit});
    }
    CHECK(inverted[0] > 10);
    CHECK(5 * inverted[1] < inverted[0]);
}

TEST_CASE("cost: the clocks look on, and change not a bit of the run")
{
    const int steps = 52;
    Scene timed = load_scene(scene_file("bunny_at_rest"), coarse),
          plain = load_scene(scene_file("bunny_at_rest"), coarse);
    const chapter06::PairTimes times = chapter06::time_stages(timed, steps);
    RunLimits limits;
    limits.steps = steps;
    run(plain, chapter06_solver(plain.contact), {}, limits);
    CHECK(times.pairs_per_step > 1);
    for (std::size_t body = 0; body < plain.world.bodies.size(); ++body)
        CHECK(std::equal(plain.world.bodies[body]->positions_t0().begin(),
                         plain.world.bodies[body]->positions_t0().end(),
                         timed.world.bodies[body]->positions_t0().begin()));
}
