#include "chapters/07_implicit_contact/experiments/depth_runs.hpp"
#include "chapters/08_speculative_contacts/experiments/ridge_scenes.hpp"
#include "chapters/08_speculative_contacts/solver.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE(
    "ridges: what comes down a centimetre goes less than a tenth of a millimetre in, also along a ridge")
{
    for (const RidgePlan& plan : ridge_plans())
        for (const double dt : {0.01, 0.002}) {
            CAPTURE(plan.name);
            CAPTURE(dt);
            Scene scene = ridge_scene(plan, dt);
            const chapter07::DepthOutcome outcome = chapter07::measure_depths(scene, 1, chapter08_solver);
            CHECK(outcome.deepest_m < 1e-4);
            CHECK(outcome.unsolved == 0);
        }
}

TEST_CASE("ridges: a box over the border of a sheet stays if its middle is over the sheet, and falls if not")
{
    for (const RidgePlan& plan : ridge_plans()) {
        if (plan.kind != RidgePlan::Kind::border)
            continue;
        CAPTURE(plan.name);
        Scene scene = ridge_scene(plan, 0.01);
        chapter07::measure_depths(scene, 1.5, chapter08_solver);
        CHECK(is_held(scene) == (plan.aside < 0));
    }
}
