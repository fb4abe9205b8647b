#include "common/experiments/run/step_costs.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/experiments/run/run.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <thread>

using namespace enduring;

namespace {

/// A box that flies on, and a solver that reports this work in each attempt.
Scene flying_box()
{
    Scene scene;
    scene.name = "flying box";
    scene.dt = 0.01;
    scene.duration = 0.03;
    scene.world.gravity.setZero();
    const SurfaceMesh mesh = box(Vec3::Ones());
    scene.world.bodies.push_back(
        std::make_unique<RigidBody>("box", mesh, mass_properties(mesh, 1), Vec3(1, 0, 0), Vec3::Zero()));
    return scene;
}

void work_for(double seconds)
{
    for (const double begin = processor_seconds(); processor_seconds() - begin < seconds;) {}
}

double cell(const Table& table, std::size_t row, const std::string& column)
{
    const auto& columns = table.columns();
    const auto place = std::find(columns.begin(), columns.end(), column) - columns.begin();
    const Cell& found = table.rows().at(row).at(static_cast<std::size_t>(place));
    return std::holds_alternative<long>(found) ? static_cast<double>(std::get<long>(found))
                                               : std::get<double>(found);
}

}  // namespace

TEST_CASE(
    "step costs: a row a step, which counts what was thrown away and tells how well the rest was solved")
{
    Scene scene = flying_box();
    Solver solver;
    solver.max_halvings = 2;
    solver.append(StepStage::refresh, "trial", [](World& world, Contacts&, double dt) {
        world.attempt.work.newton_steps = 10;
        world.attempt.work.rounds = 2;
        world.attempt.work.islands = dt > 0.004 ? 3 : 2;
        world.attempt.work.unsolved = 1;
        world.attempt.work.residual = dt > 0.004 ? 0.5 : dt;
        if (world.step == 1 && dt > 0.004)  // the second step, and its halves
            world.attempt.trouble = StepTrouble::unsolved;
    });
    StepCosts costs;
    run(scene, solver, {&costs});
    const Table& table = costs.table();
    REQUIRE(table.rows().size() == 3);
    CHECK(cell(table, 0, "attempts") == 1);
    CHECK(cell(table, 0, "residual") == 0.5);
    CHECK(cell(table, 1, "attempts") == 7);  // 1 whole, 2 halves, 4 quarters
    CHECK(cell(table, 1, "parts") == 4);
    CHECK(cell(table, 1, "newton_steps") == 70);
    CHECK(cell(table, 1, "rounds") == 14);
    CHECK(cell(table, 1, "islands") == 3);
    CHECK(cell(table, 1, "unsolved") == 4);
    CHECK(cell(table, 1, "residual") == 0.0025);
    CHECK(cell(table, 1, "ended_badly") == 0);
    CHECK(cell(table, 2, "attempts") == 1);  // each step counts anew
    CHECK(costs.column("newton_steps") == std::vector<double>{10, 70, 10});
}

TEST_CASE("step costs: a part that cannot be halved any more ended badly, and is kept")
{
    Scene scene = flying_box();
    Solver solver;
    solver.max_halvings = 1;
    solver.append(StepStage::refresh, "trial",
                  [](World& world, Contacts&, double) { world.attempt.trouble = StepTrouble::unsolved; });
    StepCosts costs;
    run(scene, solver, {&costs});
    CHECK(costs.column("attempts") == std::vector<double>{3, 2, 2});
    CHECK(costs.column("parts") == std::vector<double>{2, 2, 2});
    CHECK(costs.column("ended_badly") == std::vector<double>{2, 2, 2});
}

TEST_CASE(
    "step times: what passes take goes to search, query or solve, other threads' work too, and probes' to none")
{
    Scene scene = flying_box();
    Solver solver;
    solver.append(StepStage::refresh, "find elastic ends", [](World&, Contacts&, double) { work_for(0.02); });
    solver.append(StepStage::refresh, "find pairs", [](World&, Contacts&, double) { work_for(0.01); });
    solver.append(StepStage::detect, "query",
                  [](World&, Contacts&, double) { std::thread(work_for, 0.04).join(); });
    StepTimes times(solver);
    WatchProbe slow([](const World&, const Contacts&, double) { work_for(0.1); });
    run(scene, solver, {&slow, &times}, {.times = &times});
    REQUIRE(times.table().rows().size() == 3);
    for (std::size_t row = 0; row < 3; ++row) {
        CHECK(cell(times.table(), row, "search_ms") >= 10);
        CHECK(cell(times.table(), row, "query_ms") >= 40);
        CHECK(cell(times.table(), row, "solve_ms") >= 20);
        CHECK(cell(times.table(), row, "search_ms") < cell(times.table(), row, "solve_ms"));
        CHECK(times.totals()[row] < 165);  // 70 and the probe's 100 would be more
    }
}

TEST_CASE("step costs: mean, 99 % and worst, with the step that was the worst")
{
    std::vector<double> numbers(200, 1);
    numbers[49] = 801;
    numbers[50] = 401;
    CHECK(mean_and_worst(numbers, " ms", 1) ==
          "7 ms in the mean, 1 ms in 99 % of them, 801 ms at most (step 50)");
}
