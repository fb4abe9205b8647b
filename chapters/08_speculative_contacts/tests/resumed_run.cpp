#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/08_speculative_contacts/experiments/shapes.hpp"
#include "chapters/08_speculative_contacts/solver.hpp"
#include "chapters/08_speculative_contacts/tests/resumed.hpp"

using namespace enduring;
using namespace enduring::chapter08;

namespace {

double apart(const std::function<Scene()>& make, int saved_after, int steps, double tolerance = 1e-6)
{
    return apart_when_resumed(
        make,
        [&](const ContactParameters& parameters) {
            ImplicitSettings settings;
            settings.tolerance = tolerance;
            return chapter08_solver(parameters, settings);
        },
        saved_after, steps);
}

}  // namespace

TEST_CASE("resumed run: rigid bodies go on with the same numbers, to the last bit, wherever they were saved")
{
    for (const int saved_after : {30, 61})
        for (const unsigned seed : {1U, 2U}) {
            CAPTURE(saved_after);
            CAPTURE(seed);
            CHECK(apart(
                      [&] {
                          return random_heap({mixed_family, 8, seed == 1 ? 0.01 : 0.004, 0.5, seed});
                      },
                      saved_after, 80) == 0);
        }
}

TEST_CASE(
    "resumed run: a soft body goes on as it did, but for what its linear solver and the tolerance of contact leave")
{
    // Another factor may end the rounds of contact one earlier or later. A sharper tolerance makes that as small.
    for (const double tolerance : {1e-6, 1e-10})
        for (const int saved_after : {10, 40}) {
            CAPTURE(tolerance);
            CAPTURE(saved_after);
            CHECK(apart(
                      [] {
                          return chapter07::soft_cube_on_triangles({2, 1e6, 0.01, 100}, 0.4);
                      },
                      saved_after, 60, tolerance) < 1000 * tolerance);
        }
}
