#include "chapters/07_implicit_contact/solver.hpp"
#include "common/experiments/run/run.hpp"
#include "common/scenes/scene_reader.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

using namespace enduring;

namespace {

/// Cubes apart from each other: three fall from little height, and one arrives so fast that its landing is
/// taken in halves.
constexpr const char* landing = R"({
  "name": "landing", "dt": 0.01, "duration": 0.3, "planes": [{"name": "ground"}],
  "bodies": [
    {"name": "a", "type": "rigid", "shape": {"box": {"size": [1, 1, 1]}}, "density": 100, "position": [0, 0.6, 0]},
    {"name": "b", "type": "rigid", "shape": {"box": {"size": [1, 1, 1]}}, "density": 100, "position": [3, 0.55, 0]},
    {"name": "c", "type": "rigid", "shape": {"box": {"size": [1, 1, 1]}}, "density": 100, "position": [6, 0.7, 0]},
    {"name": "fast", "type": "rigid", "shape": {"box": {"size": [1, 1, 1]}}, "density": 100, "position": [9, 8, 0],
     "velocity": [0, -200, 0], "angular_velocity": [2, 0, 5]}]})";

struct Costs {
    StepCosts table;
    long recorded = 0;     ///< steps of Newton's method that the solver's record tells
    long thrown_away = 0;  ///< attempts, as the world counts them
};

void run_landing(Costs& costs, int threads)
{
    Scene scene = read_scene(landing, "", "landing", {});
    ImplicitSettings settings;
    settings.threads = threads;
    settings.pairs_for_threads = 0;
    settings.record = [&](const SolveRecord& record) { costs.recorded += record.newton_steps; };
    run(scene, chapter07_solver(scene.contact, settings), {&costs.table});
    costs.thrown_away = scene.world.thrown_away;
}

double sum(const std::vector<double>& numbers)
{
    return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

}  // namespace

TEST_CASE(
    "step work: attempts that are thrown away are counted, and all islands, and the solver's record leaves them out")
{
    Costs costs;
    run_landing(costs, 1);
    CAPTURE(csv(costs.table.table()));
    REQUIRE(costs.thrown_away > 0);
    CHECK(sum(costs.table.column("attempts")) - sum(costs.table.column("parts")) ==
          static_cast<double>(costs.thrown_away));
    CHECK(sum(costs.table.column("newton_steps")) > static_cast<double>(costs.recorded));
    const std::vector<double> islands = costs.table.column("islands");
    CHECK(*std::max_element(islands.begin(), islands.end()) >= 3);  // those that fell from little height
}

TEST_CASE("step work: the table has the same bytes for any number of threads")
{
    Costs one, four;
    run_landing(one, 1);
    run_landing(four, 4);
    CHECK(csv(one.table.table()) == csv(four.table.table()));
}

TEST_CASE(
    "step work: the pass whose time belongs to the solve, though it runs before the search, has this name")
{
    CHECK_NOTHROW(chapter07_solver({}, {}).pass("find elastic ends"));
}
