#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/07_implicit_contact/tests/check_after.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"

using namespace enduring;
using chapter07::check_after;

TEST_CASE("card house: after half a second it stands as in its reference picture" *
          doctest::skip(!pictures_are_on))
{
    check_after(chapter07::scene_of(chapter07::card_house(3, 15), 1.0 / 60), 0.5, chapter08_solver,
                {1, 0.6, 2}, "08_contact_by_distance/card_house.png");
}

TEST_CASE("arch: after half a second it stands as in its reference picture" * doctest::skip(!pictures_are_on))
{
    check_after(chapter07::arch(20, 5, 1.0 / 60), 0.5, chapter08_solver, {0.8, 0.4, 2},
                "08_contact_by_distance/arch.png");
}
