#include "chapters/05_categorisation/category.hpp"
#include "chapters/05_categorisation/solver.hpp"
#include "chapters/06_redefinition/experiments/bar_slide.hpp"
#include "chapters/06_redefinition/experiments/plane_slide.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/experiments/run/run.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;
using namespace enduring::chapter06;

namespace {

#ifdef __SANITIZE_ADDRESS__
// sanitizers look for other faults, at ten times the cost: two directions are enough for them
constexpr int stride = 7;
#else
constexpr int stride = 1;
#endif

}  // namespace

TEST_CASE("sliding: over 20 cells of every triangulation, in eight directions, no speed is lost or won" *
          doctest::test_suite("long simulation"))
{
    for (const GridDiagonals diagonals : all_diagonals)
        for (int direction = 0; direction < 8; direction += stride) {
            PlaneSlide slide{diagonals, direction};
            slide.on_lattice = direction % 3 == 0;
            slide.dt = 0.002;
            CAPTURE(name_of(diagonals));
            CAPTURE(direction);
            const SlideOutcome outcome = slide_over_plane(slide, chapter06_solver(scene_of(slide).contact));
            CHECK(std::abs(outcome.speed_change) < 0.001);
            CHECK(outcome.sideways_speed < 0.001);
            CHECK(outcome.sag < 1e-4);
            CHECK(outcome.lowest < -0.2 * outcome.sag);  // it lies in the floor all the way
            CHECK(outcome.highest < 0);
            CHECK(outcome.lowest > -4e-4);
        }
}

TEST_CASE("sliding: chapter 5 stops on the same floor")
{
    PlaneSlide slide;
    slide.dt = 0.002;
    CHECK(slide_over_plane(slide, chapter05_solver(scene_of(slide).contact)).speed_change < -0.9);
}

TEST_CASE("sliding: past the stable step sqrt(2m / (n k)) the cube hops")
{
    PlaneSlide slide;
    slide.direction = 1;
    slide.stiffness = 3e6;
    slide.may_gain_energy = true;
    const SlideOutcome outcome = slide_over_plane(slide, chapter06_solver(scene_of(slide).contact));
    CHECK(outcome.highest > 10 * outcome.sag);
}

TEST_CASE("sliding: on the soft bar the cube keeps its speed with redefinition, and stops without" *
          doctest::test_suite("long simulation"))
{
    for (const bool redefined : {true, false}) {
        Scene scene = load_scene(scene_file("sliding"));
        run(scene, redefined ? chapter06_solver(scene.contact) : chapter05_solver(scene.contact), {},
            {350, {}});
        const Body& cube = body_named(scene.world, "cube");
        CHECK((cube.linear_momentum().x() / cube.mass() > 0.95 * 1.2) == redefined);
        CHECK((cube.linear_momentum().x() / cube.mass() < 0.5 * 1.2) == !redefined);
    }
}

TEST_CASE(
    "sliding: on the soft bar the force between cube and bar is the cube's weight, smooth but for leaps where pairs come and go" *
    doctest::test_suite("long simulation"))
{
    constexpr double settled = 0.3;  // [s]
    Scene scene = load_scene(scene_file("sliding"));
    BarSlideProbe probe("test");
    run(scene, chapter06_solver(scene.contact), {&probe}, {600, {}});
    double force = 0;
    long moments = 0;
    for (const BarSlideProbe::Moment& moment : probe.moments())
        if (moment.time >= settled) {
            force += moment.force;
            ++moments;
        }
    CHECK(force / static_cast<double>(moments) == doctest::Approx(probe.weight()).epsilon(0.03));
    const BarSlideOutcome outcome = outcome_of(probe, settled, 10);
    CHECK(outcome.mean_leap < 0.02);
    CHECK(outcome.largest_leap > 5 * outcome.mean_leap);
    CHECK(outcome.largest_leap < 0.6);
}
