#include "chapters/07_implicit_contact/experiments/spinning_box.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;
using namespace enduring::chapter07;

TEST_CASE(
    "spinning: boxes that turn by radians in a step land and gain nothing, while in whole steps they do")
{
    const double max_turn = chapter07_solver(ContactParameters{}).max_turn;
    int whole_steps_gain = 0;
    for (unsigned seed = 1; seed <= 5; ++seed)
        for (const double turn : {1.0, 3.0, 6.0}) {
            CAPTURE(seed);
            CAPTURE(turn);
            SolveStatistics solves;
            CHECK(max_energy(spinning_box(turn, 0.01, seed), chapter07_solver, max_turn, solves) <= 1);
            CHECK(solves.unconverged == 0);
            whole_steps_gain += max_energy(spinning_box(turn, 0.01, seed), chapter07_solver, INFINITY,
                                           solves) > 1.001;
        }
    CHECK(whole_steps_gain > 3);
}

TEST_CASE("spinning: boxes that turn by three radians in a step are taken in halves, and each part ends well")
{
    for (unsigned seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        Scene scene = spinning_box(3, seed % 2 == 0 ? 0.01 : 1.0 / 60, seed);
        const Solver solver = chapter07_solver(scene.contact);
        Contacts contacts;
        const double first = total_energy(scene.world).total();
        for (int i = 0; i < 50; ++i)
            advance(scene.world, contacts, solver, scene.dt);
        CHECK(total_energy(scene.world).total() <= first);
        CHECK(scene.world.ended_badly == 0);
    }
}
