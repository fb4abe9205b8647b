#include "chapters/08_contact_by_distance/experiments/forces.hpp"

#include "chapters/08_contact_by_distance/experiments/forces_frames.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_impacts.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_landing.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_soft.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_statics.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/08_contact_by_distance/tests/check_rows.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace enduring;
using namespace enduring::chapter08;
using namespace enduring::chapter08::force_rows;

namespace {

Solver quiet(const ContactParameters& parameters)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    return chapter08_solver(parameters, settings);
}

}  // namespace

TEST_CASE("forces: a row without runs, and a force that is no number, do not hold")
{
    Row row{"key", "scene", "quantity", "formula", 1};
    CHECK(!row.holds());
    row.add("first", 0.5);
    CHECK(row.holds());
    row.add("second", NAN);
    row.add("third", 0.7);
    CHECK(!row.holds());
    CHECK(row.worst == "second");
}

TEST_CASE("forces: pairs carry the weight of what rests on them, each with k times its depth")
{
    check_rows(weights(quiet, false));
}

TEST_CASE("forces: the legs of a table carry it and its load, and legs that are mirror images carry the same")
{
    check_rows(tables(quiet, false));
}

TEST_CASE("forces: what is symmetric is carried symmetrically, whatever the triangles of the floor")
{
    check_rows(mirror_images(quiet, false));
}

TEST_CASE("forces: a pile's base carries its weight") { check_rows(piles(quiet, false)); }

TEST_CASE("forces: on a slope below the threshold friction is m g sin") { check_rows(slopes(quiet, false)); }

TEST_CASE("forces: a wedge presses its sides as statics says") { check_rows(wedges(quiet, false)); }

TEST_CASE("forces: bars that lean against each other have the thrust of a frame of three hinges")
{
    check_rows(frames(quiet, false));
}

TEST_CASE("forces: the thrust of an arch is the same in each joint, and each stone is in balance")
{
    check_rows(arches(quiet, false));
}

TEST_CASE("forces: each ring of a chain carries the rings below it") { check_rows(chains(quiet, false)); }

TEST_SUITE("long simulation")
{
    TEST_CASE("forces: soft blocks are carried with their weight") { check_rows(soft_weights(quiet, false)); }

    TEST_CASE("forces: a soft block between plates presses each vertex by its share of the area")
    {
        check_rows(soft_pressure(quiet, false));
    }
}

TEST_CASE("forces: the order in which bodies are listed changes no force")
{
    check_rows(either_order(quiet, false));
}

TEST_CASE("forces: a ball that drops straight does not spin, and its largest force stops it")
{
    check_rows(straight_drops(quiet, false));
}

TEST_CASE("forces: in each step of an impact, forces times the step are the change of momentum")
{
    check_rows(momentum_of_impacts(quiet, false));
}

TEST_CASE(
    "forces: the speed of rolling solves both equations of a step, and in short steps is v / (1 + I / (m R^2))")
{
    for (const double ratio : {0.4, 0.5, 1.0})
        for (const double dt : {1.0 / 60, 0.001}) {
            const double v = rolling_speed(2, ratio, 0.1, dt), spin = (2 - v) / (ratio * 0.1);
            CHECK(0.1 * std::sin(spin * dt) == doctest::Approx(v * dt).epsilon(1e-12));
        }
    CHECK(rolling_speed(2, 0.4, 0.1, 1e-5) == doctest::Approx(2 / 1.4).epsilon(1e-6));
}

TEST_CASE("forces: what lands while it slides rolls with the speed that its inertia leaves it")
{
    check_rows(landings(quiet, false));
}

TEST_CASE("forces: a step that does not come to the levers of its motion is halved, and not kept")
{
    for (const double drop : {0.3, 1.25}) {
        const Landed landed = land({.shape = Round::cylinder, .drop = drop, .dt = 1.0 / 30, .turns = 24},
                                   quiet);
        CHECK_MESSAGE(landed.worst < 0.05, drop);
    }
}

TEST_CASE("forces: a rod that lands on its end turns by its lever") { check_rows(rods_on_end(quiet, false)); }

TEST_CASE(
    "forces: a ball that strikes two shares its momentum, and backspin climbs a wall as far as friction lets it")
{
    check_rows(struck_balls(quiet, false));
}
