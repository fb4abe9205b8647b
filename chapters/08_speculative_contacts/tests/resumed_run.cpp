#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/08_speculative_contacts/experiments/shapes.hpp"
#include "chapters/08_speculative_contacts/experiments/soft_contact_scenes.hpp"
#include "chapters/08_speculative_contacts/solver.hpp"
#include "chapters/08_speculative_contacts/tests/resumed.hpp"

using namespace enduring;
using namespace enduring::chapter08;

namespace {

double apart(const std::function<Scene()>& make, int saved_after, int steps)
{
    return apart_when_resumed(
        make, [](const ContactParameters& parameters) { return chapter08_solver(parameters); }, saved_after,
        steps);
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

TEST_CASE("resumed run: what spins and lands in halved steps goes on with the same numbers, too")
{
    const HeapPlan notches{4, 8, 0.02, 0.1, 74, 30}, tetrahedra{0, 8, 0.01, 0, 198, 30},
        lumps{6, 6, 0.02, 0.5, 4, 30};
    for (const HeapPlan& plan : {notches, tetrahedra, lumps})
        for (const double saved_at : {0.4, 0.6}) {
            CAPTURE(family_name(plan.family));
            CAPTURE(saved_at);
            CHECK(apart([&] { return random_heap(plan); }, static_cast<int>(std::lround(saved_at / plan.dt)),
                        static_cast<int>(std::lround(0.8 / plan.dt))) == 0);
        }
}

TEST_CASE(
    "resumed run: soft bodies go on with the same numbers, to the last bit, on the ground and on each other")
{
    for (const int saved_after : {10, 40}) {
        CAPTURE(saved_after);
        CHECK(apart(
                  [] {
                      return chapter07::soft_cube_on_triangles({2, 1e6, 0.01, 100}, 0.4);
                  },
                  saved_after, 60) == 0);
    }
    for (const Basis basis : {Basis::linear, Basis::quadratic}) {
        CAPTURE(static_cast<int>(basis));
        CHECK(apart([&] { return soft_collision({basis, 1e5, 0.005, 1}); }, 13, 30) == 0);
    }
}
