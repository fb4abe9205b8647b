#include "chapters/10_self_contact/experiments/round_turn.hpp"
#include "chapters/10_self_contact/solver.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;
using namespace enduring::chapter10;

namespace {

constexpr double thickness = RoundTurn().thickness;

/// How far a rope comes around its own end [m].
struct Displacement {
    double all = 0;   ///< in a tenth of a second, or until it is ten thicknesses
    double late = 0;  ///< of it in the second half of this time
};

Displacement displacement(double mu, double ratio)
{
    constexpr int steps = 50;
    const RoundTurn shape;
    RoundTurnRun turn = round_turn(shape, {.young = 1e6, .cells = 1, .dt = 0.002, .mu = mu}, 0.3, ratio);
    const Solver solver = pulling(chapter10_solver(turn.soft.scene.contact), turn.soft.pulls);
    const double start = displacement_of_turn(shape, turn);
    Contacts contacts;
    Displacement turned;
    double early = 0;
    for (int step = 0; step < steps && turned.all < 10 * thickness; ++step) {
        if (step <= steps / 2)
            early = turned.all;
        advance(turn.soft.scene.world, contacts, solver, turn.soft.scene.dt);
        turned.all = displacement_of_turn(shape, turn) - start;
        turned.late = turned.all - early;
    }
    return turned;
}

}  // namespace

TEST_CASE(
    "self-contact: a rough rope's turn around its own end holds a fourfold pull, a slippery one's slips" *
    doctest::test_suite("long simulation"))
{
    const Displacement held = displacement(0.5, 4);
    CHECK(held.all < 0.5 * thickness);
    CHECK(std::abs(held.late) < 0.02 * thickness);
    CHECK(displacement(0.02, 4).all >= 10 * thickness);
}

TEST_CASE(
    "self-contact: a rope's turn holds two thirds of the capstan ratio, and slides at three halves of it" *
    doctest::test_suite("long simulation"))
{
    for (const double mu : {0.1, 0.2}) {
        CAPTURE(mu);
        const double most = std::exp(mu * RoundTurn().angle());
        const Displacement held = displacement(mu, most / 1.5), slid = displacement(mu, most * 1.5);
        CHECK(held.all < thickness);
        CHECK(std::abs(held.late) < 0.02 * thickness);
        CHECK(slid.all > 2 * thickness);
    }
}
