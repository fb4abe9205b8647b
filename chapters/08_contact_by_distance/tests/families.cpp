#include "chapters/07_implicit_contact/experiments/depth_runs.hpp"
#include "chapters/08_contact_by_distance/experiments/shapes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE(
    "families: no body comes deeper than half a percent of its size, nor rests deeper than a hundredth of it")
{
    for (int family = 0; family < family_count; ++family)
        for (const unsigned seed : {1U, 2U}) {
            CAPTURE(family_name(family));
            CAPTURE(seed);
            Scene scene = random_heap({family, 5, 0.01, 0.5, seed});
            const chapter07::DepthOutcome outcome = chapter07::measure_depths(scene, 1.6, chapter08_solver);
            CHECK(outcome.deepest_m < 5e-3 * outcome.size_m);
            CHECK(outcome.at_end_m < 1e-4 * outcome.size_m);
            CHECK(outcome.gain < 1e-3);
            CHECK(outcome.unsolved == 0);
            CHECK(outcome.lost == 0);
        }
}

TEST_CASE(
    "families: with long steps and spin, too, what ends near another body has a pair, and one that spins pushes as its face lies at the end")
{
    for (const HeapPlan& plan : {HeapPlan{0, 8, 0.02, 0, 44, 30}, HeapPlan{7, 8, 0.02, 0.4, 54, 30},
                                 HeapPlan{8, 8, 0.02, 0.1, 19, 0}, HeapPlan{8, 8, 0.01, 0.1, 63, 0},
                                 // behind a face, beyond its edge
                                 HeapPlan{0, 8, 0.01, 0, 198, 30},
                                 // what an answer lifts, the next one lets down
                                 HeapPlan{1, 8, 0.02, 0.8, 9, 0},
                                 // a face turns towards a vertex that flies along it
                                 HeapPlan{1, 8, 0.01, 0.8, 163, 0},
                                 // an edge slides through the corner of a notch, from edge to edge
                                 HeapPlan{4, 8, 0.01, 0.5, 73, 0},
                                 // from behind a face round its edge, and then through it
                                 HeapPlan{4, 8, 0.02, 0.1, 74, 30},
                                 // it slides past a corner, and passes another face than the nearest ones
                                 HeapPlan{6, 8, 0.005, 0, 187, 0},
                                 // behind a face's plane at first, beyond its edge, it passes another face
                                 HeapPlan{6, 8, 0.02, 0.1, 184, 30}}) {
        CAPTURE(family_name(plan.family));
        Scene scene = random_heap(plan);
        const chapter07::DepthOutcome outcome = chapter07::measure_depths(scene, 1, chapter08_solver);
        CHECK(outcome.deepest_m < 5e-3 * outcome.size_m);
    }
}

TEST_CASE("families: two thin plates that have landed are soon out of the ground and of each other")
{
    constexpr int plates = 7;
    for (const HeapPlan& plan :
         {HeapPlan{plates, 2, 0.02, 0.5, 7, 0}, HeapPlan{plates, 2, 0.02, 0.5, 40, 30}}) {
        CAPTURE(plan.seed);
        Scene scene = random_heap(plan);
        const chapter07::DepthOutcome outcome = chapter07::measure_depths(scene, 2, chapter08_solver);
        CHECK(outcome.at_end_m < 2e-5 * outcome.size_m);
    }
}
