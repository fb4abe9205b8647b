#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/07_implicit_contact/tests/check_after.hpp"

using namespace enduring;
using namespace enduring::chapter07;

TEST_CASE("stack: ten cubes, each turned against the one below, stand as in their reference picture" *
          doctest::skip(!pictures_are_on))
{
    check_after(scene_of(stack_of(10), 0.01), 0.5, chapter07_solver, {1, 0.4, 2},
                "07_implicit_contact/stack.png");
}
