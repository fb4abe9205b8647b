#include "chapters/11_exact_contact/solver.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_speculative_contacts/search_parts.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

TEST_CASE("remembered forces: a cube on springs of h = 100 comes to rest at no depth")
{
    Scene scene = chapter07::scene_of(chapter07::stack_of(1), 0.01);
    scene.contact.wanted_depth = 1;
    ImplicitSettings settings;
    settings.stiffness.k_dt2_over_m = 100 / search_parts.stiffer;
    const Solver solver = chapter11_solver(scene.contact, settings);
    Contacts contacts;
    for (int step = 0; step < 2000; ++step)
        advance(scene.world, contacts, solver, scene.dt);
    CHECK(std::abs(scene.world.bodies.back()->centre().y() - 0.5) <= 1e-11);
}

TEST_CASE(
    "remembered forces: an offset stays where it holds the whole force, and a pair that is deep keeps its own")
{
    Contact resting;
    resting.stiffness = 1000;
    resting.impulse = Vec3(0, 0.5, 0);  // 50 N: 5 cm
    resting.rest_offset = 0.05;
    Contact deep = resting;
    deep.rest_offset = -0.3;
    Contacts contacts{resting, deep};
    remember_forces(contacts, 0.9, 0.01);
    CHECK(contacts[0].rest_offset == doctest::Approx(0.05 / 0.9));  // of which the next step keeps 0.9
    CHECK(contacts[1].rest_offset == -0.3);
}
