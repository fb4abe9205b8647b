#include "chapters/08_speculative_contacts/experiments/bolt.hpp"
#include "chapters/08_speculative_contacts/experiments/soft_slide.hpp"
#include "chapters/08_speculative_contacts/experiments/swings.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE(
    "frictionless: with short steps a block in a half pipe keeps what an inelastic body keeps, to 3 percent, over coarse and fine facets")
{
    for (const int facets : {60, 480})
        for (const double dt : {0.0025, 0.001}) {
            CAPTURE(facets);
            CAPTURE(dt);
            Swing swing = block_in_pipe(facets, dt);
            const SwingOutcome outcome = watch_swing(swing);
            // 2.3 percent with 60 facets and 2.5 ms
            CHECK(outcome.kept == doctest::Approx(inelastic_bound(swing)).epsilon(0.03));
            CHECK(outcome.period_s == doctest::Approx(pendulum_period(swing, 0.6)).epsilon(0.01));
            CHECK(outcome.deepest_mm < 100 * dt);
        }
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

TEST_CASE("frictionless: with short steps a bolt falls through its nut as its energy says, to a tenth")
{
    const BoltFall fall = drop_bolt({.dt = 0.0025});
    CHECK(fall.fallen_mm == doctest::Approx(fall.by_energy_mm).epsilon(0.1));  // 8.1 mm of 8.9 mm
    CHECK(fall.aside_mm < 0.05);
    CHECK(fall.solves.unconverged == 0);
}
