#include "chapters/06_redefinition/experiments/levers.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter07;

TEST_CASE(
    "free collision: linear momentum is kept to rounding, and angular momentum but for the slide before the impact")
{
    SolveStatistics solves;
    for (const double dt : {0.004, 0.002})
        for (const double arrives : {0.1, 0.5, 0.9}) {
            const chapter06::LeverCost cost = chapter06::cost_of_levers(
                {dt, 1, 0.2 * dt * arrives, {}}, counting_solver(chapter07_solver, solves));
            CHECK(cost.linear.norm() < 1e-12);
            CHECK(cost.measured.norm() ==
                  doctest::Approx(cost.pushed * dt * arrives * (1 - arrives)).epsilon(0.1));
        }
}

TEST_CASE("order: a stack whose cubes stand in another order in their scene moves the same, but for rounding")
{
    const std::vector<Box> boxes = stack_of(5), reversed(boxes.rbegin(), boxes.rend());
    Scene first = scene_of(boxes, 0.01), again = scene_of(boxes, 0.01), other = scene_of(reversed, 0.01);
    for (Scene* scene : {&first, &again, &other})
        watch(*scene, 1, chapter07_solver);
    for (std::size_t box = 0; box < boxes.size(); ++box)
        for (std::size_t v = 0; v < 8; ++v) {
            const Vec3& place = first.world.bodies[box]->positions_t0()[v];
            CHECK(place == again.world.bodies[box]->positions_t0()[v]);
            CHECK((place - other.world.bodies[boxes.size() - 1 - box]->positions_t0()[v]).norm() < 1e-10);
        }
}
