#include "chapters/08_contact_by_distance/experiments/bolt.hpp"
#include "chapters/08_contact_by_distance/experiments/soft_slide.hpp"
#include "chapters/08_contact_by_distance/experiments/swings.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE(
    "frictionless: a block in a half pipe keeps what an inelastic body keeps, to 2 percent, over coarse and fine facets, with long and short steps")
{
    for (const int facets : {60, 480})
        for (const double dt : {0.01, 0.005, 0.0025}) {
            CAPTURE(facets);
            CAPTURE(dt);
            Swing swing = block_in_pipe(facets, dt);
            const SwingOutcome outcome = watch_swing(swing);
            CHECK(outcome.kept == doctest::Approx(inelastic_bound(swing)).epsilon(0.02));
            CHECK(outcome.period_s == doctest::Approx(pendulum_period(swing, 0.6)).epsilon(0.01));
            CHECK(outcome.deepest_mm < 0.3);
        }
}

TEST_CASE("frictionless: a block inside an upright torus keeps what an inelastic body keeps, to a hundredth")
{
    Swing swing = block_in_torus(240, 0.0025);
    const SwingOutcome outcome = watch_swing(swing);
    CHECK(outcome.kept == doctest::Approx(inelastic_bound(swing)).epsilon(0.01));
    CHECK(outcome.period_s == doctest::Approx(pendulum_period(swing, 0.6)).epsilon(0.01));
    CHECK(outcome.deepest_mm < 0.3);
}

TEST_CASE("frictionless: a ball in a bowl of triangles keeps what an inelastic body keeps, to 2 percent")
{
    Swing swing = ball_in_bowl(24, 8, 0.0025);
    const SwingOutcome outcome = watch_swing(swing);
    CHECK(outcome.kept == doctest::Approx(inelastic_bound(swing)).epsilon(0.02));
    CHECK(outcome.period_s == doctest::Approx(pendulum_period(swing, 0.6)).epsilon(0.01));
}

TEST_CASE("frictionless: a soft cube slides over triangles as on a plane, to a thousandth")
{
    for (const int cells : {2, 3}) {
        CAPTURE(cells);
        const SoftSlide slide = slide_without_friction({cells, 1e5, 0.01, 100}, 1.5);
        CHECK(slide.speed == doctest::Approx(slide.by_formula).epsilon(1e-3));
    }
}

TEST_CASE("frictionless: a bolt falls through its nut as its energy says, to 3 percent")
{
    for (const double dt : {0.0025, 0.01}) {
        CAPTURE(dt);
        const BoltFall fall = drop_bolt({.dt = dt});
        CHECK(fall.fallen_mm == doctest::Approx(fall.by_energy_mm).epsilon(0.03));
        CHECK(fall.aside_mm < 0.05);
        CHECK(fall.energy_gain_j == 0);
        CHECK(fall.solves.unconverged == 0);
    }
}
