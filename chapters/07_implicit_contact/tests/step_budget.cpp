#include "chapters/07_implicit_contact/step_budget.hpp"

#include <doctest/doctest.h>

#include <utility>

using namespace enduring;

namespace {

constexpr double dt = 0.01;

World in_a_step(bool may_be_halved = true)
{
    World world;
    world.whole_dt = dt;
    world.attempt.may_be_halved = may_be_halved;
    return world;
}

}  // namespace

TEST_CASE("step budget: islands share it by their pairs, over all attempts, and the next step has a new one")
{
    const BudgetLimits limits{100, 300, 10, 60, 100, 5, 2};
    World world = in_a_step();
    StepBudget budget;
    budget.begin_response(world, limits, 100);
    CHECK(budget.of_island(world, limits, 0, dt).newton_steps == 100);
    CHECK(budget.of_island(world, limits, 70, dt).newton_steps == 100);
    budget.take(400, 0.25);
    budget.take(200, 0.5);
    CHECK(budget.of_island(world, limits, 0, dt).newton_steps == 100);
    CHECK_FALSE(budget.of_island(world, limits, 0, dt).is_last);
    world.work.attempts = 1;  // thrown away
    budget.begin_response(world, limits, 100);
    budget.take(80, 0.5);
    CHECK(budget.of_island(world, limits, 0, dt).newton_steps == 60);
    CHECK(budget.of_island(world, limits, 30, dt).newton_steps == 90);
    budget.take(1000, 1);
    CHECK(budget.of_island(world, limits, 30, dt).newton_steps == 40);
    world.attempt.work.responses = 1;
    world.work.attempts = 0;
    budget.begin_response(world, limits, 100);
    CHECK(budget.of_island(world, limits, 0, dt).newton_steps == 10);
    world.attempt.work.responses = 0;  // of another step
    budget.begin_response(world, limits, 100);
    CHECK(budget.of_island(world, limits, 0, dt).newton_steps == 100);
}

TEST_CASE("step budget: with few pairs there is more of it, up to five times as much")
{
    const BudgetLimits limits{100, 300, 10, 60, 100, 5, 2};
    World world = in_a_step();
    StepBudget budget;
    for (const auto& [pairs, times] : {std::pair{1000, 1}, {50, 2}, {20, 5}, {3, 5}, {0, 5}}) {
        CAPTURE(pairs);
        world.work.attempts = 0;
        budget.begin_response(world, limits, pairs);
        CHECK(budget.of_island(world, limits, 0, dt).newton_steps == 100 * times);
        budget.take(250 * times, 1);
        CHECK(budget.of_island(world, limits, 0, dt).newton_steps == 50 * times);
        budget.take(50 * times, 1);
        CHECK(budget.of_island(world, limits, 0, dt).newton_steps == 10 * times);
    }
}

TEST_CASE("step budget: what is not solved is halved twice, and not when the budget is used up")
{
    const BudgetLimits limits{100, 300, 10, 60, 100, 5, 2};
    const World world = in_a_step();
    StepBudget budget;
    CHECK_FALSE(budget.of_island(world, limits, 0, dt).is_last);
    CHECK_FALSE(budget.of_island(world, limits, 0, dt / 2).is_last);
    CHECK(budget.of_island(world, limits, 0, dt / 4).is_last);
    CHECK(budget.of_island(in_a_step(false), limits, 0, dt).is_last);
    budget.take(201, 1);
    CHECK(budget.of_island(world, limits, 0, dt).is_last);
}
