#include "chapters/08_contact_by_distance/tests/resumed.hpp"
#include "chapters/10_self_contact/experiments/folding_scenes.hpp"
#include "chapters/10_self_contact/solver.hpp"

using namespace enduring;
using namespace enduring::chapter10;

TEST_CASE("resumed run: a strip that folds on itself goes on with the same numbers, to the last bit")
{
    const auto make = [] { return falling_strip({2e5, 2, 0.01, 0.5}).scene; };
    const auto solver = [](const ContactParameters& parameters) { return chapter10_solver(parameters); };
    CHECK(chapter08::apart_when_resumed(make, solver, 30, 50) == 0);
}
