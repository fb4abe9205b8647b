#include "chapters/08_contact_by_distance/experiments/soft_piles.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

/// After any step of a run [m]; no element is inside out.
double deepest_ever(Scene& scene, double duration)
{
    double deepest = 0;
    WatchProbe probe([&](const World& world, const Contacts&, double) {
        deepest = std::max(deepest, chapter07::true_depth(world));
        for (const auto& body : world.bodies)
            CHECK(body->inverted_elements() == 0);
    });
    const chapter07::PileOutcome outcome = chapter07::watch(scene, duration, chapter08_solver, &probe);
    CHECK(outcome.energy_gain_j < 1e-9);
    CHECK(outcome.solves.unconverged == 0);
    return deepest;
}

}  // namespace

TEST_CASE("soft piles: a sheet of soft elements lies over a ball, and no vertex or edge comes into it" *
          doctest::test_suite("long simulation"))
{
    Scene scene = sheet_over_ball({.cells = 6, .young = 2e5, .thick = 0.03, .dt = 0.008});
    CHECK(deepest_ever(scene, 0.6) < 1e-4);
    const auto& sheet = *scene.world.bodies[1];
    double lowest = 1;
    for (const Vec3& vertex : sheet.positions_t0())
        lowest = std::min(lowest, vertex.y());
    CHECK(lowest < 0.8);  // its corners hang
    CHECK(lowest > 0.1);  // it has not fallen off
}

TEST_CASE("soft piles: soft blocks on one another stay above one another, with another step" *
          doctest::test_suite("long simulation"))
{
    Scene scene = soft_stack({.blocks = 3, .young = 1e6, .dt = 1.0 / 60});
    CHECK(deepest_ever(scene, 0.5) < 1e-4);
    for (std::size_t i = 1; i < 3; ++i)
        CHECK(scene.world.bodies[i]->centre().y() - scene.world.bodies[i - 1]->centre().y() > 0.38);
}
