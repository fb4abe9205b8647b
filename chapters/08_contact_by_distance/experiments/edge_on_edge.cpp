#include "chapters/07_implicit_contact/experiments/rest_runs.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

using Boxes = std::vector<chapter07::Box>;

chapter07::Box brick(const Vec3& size, const Vec3& centre)
{
    chapter07::Box box;
    box.size = size;
    box.centre = centre;
    return box;
}

Boxes tower(int cubes) { return chapter07::stack_of(cubes, 10, 10, 0); }

/// Side by side, behind and on one another.
Boxes block_of_cubes(int side)
{
    Boxes boxes;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (int z = 0; z < side; ++z)
                boxes.push_back(brick(Vec3::Ones(), Vec3(x, y + 0.5, z)));
    return boxes;
}

/// In every other layer the bricks begin a little farther on.
Boxes wall(int layers, int bricks)
{
    Boxes boxes;
    for (int y = 0; y < layers; ++y)
        for (int x = 0; x < bricks; ++x)
            boxes.push_back(brick({2, 1, 1}, Vec3(2 * x + 0.8 * (y % 2), y + 0.5, 0)));
    return boxes;
}

Boxes pyramid(int layers)
{
    Boxes boxes;
    for (int y = 0; y < layers; ++y)
        for (int x = 0; x < layers - y; ++x)
            boxes.push_back(brick(Vec3::Ones(), Vec3(x + 0.5 * y, y + 0.5, 0)));
    return boxes;
}

/// Three beams side by side in each layer, across those below.
Boxes crossed_beams(int layers)
{
    Boxes boxes;
    for (int y = 0; y < layers; ++y)
        for (int i = -1; i <= 1; ++i) {
            const bool across = y % 2 == 1;
            boxes.push_back(brick(across ? Vec3(1, 0.5, 3) : Vec3(3, 0.5, 1),
                                  across ? Vec3(i, 0.5 * y + 0.25, 0) : Vec3(0, 0.5 * y + 0.25, i)));
        }
    return boxes;
}

/// All together, about the axis.
Boxes turned(Boxes boxes, double turn_deg)
{
    const Eigen::AngleAxisd turn(turn_deg * std::numbers::pi / 180, Vec3::UnitY());
    for (chapter07::Box& box : boxes) {
        box.centre = turn * box.centre;
        box.turn_deg = turn_deg;
    }
    return boxes;
}

struct Building {
    std::string name;
    Boxes boxes;
    bool pictured = false;
};

std::vector<Building> all_buildings(bool quick)
{
    if (quick)
        return {
            {"tower of 5", tower(5)}, {"block of 8", block_of_cubes(2), true}, {"pyramid of 6", pyramid(3)}};
    return {{"tower of 5", tower(5)},
            {"tower of 10", tower(10)},
            {"tower of 20", tower(20)},
            {"block of 27", block_of_cubes(3), true},
            {"wall of 30 bricks", wall(6, 5), true},
            {"pyramid of 21", pyramid(6), true},
            {"crossed beams, 24", crossed_beams(8), true}};
}

std::vector<chapter07::RestRuns::Case> all_cases(bool quick)
{
    constexpr double stands_mm = 10;
    std::vector<chapter07::RestRuns::Case> cases;
    for (const double dt : {0.01, 1.0 / 60})
        for (const double turn_deg : {0.0, 17.0, 45.0})
            for (const Building& building : all_buildings(quick))
                if (!quick || turn_deg <= 17)
                    cases.push_back(
                        {building.name + ", turned by " + std::to_string(std::lround(turn_deg)) + "°",
                         chapter07::scene_of(turned(building.boxes, turn_deg), dt), quick ? 3.0 : 10.0,
                         building.pictured && dt == 0.01 && turn_deg == 0, stands_mm, Vec3(1, 0.7, 1.4)});
    return cases;
}

}  // namespace

/// What people build first, laid exactly side by side and edge on edge: does it stand still? Its angle to the
/// axes decides how coordinates are rounded.
void edge_on_edge(const RunOptions& options, Report& report)
{
    std::vector<chapter07::RestRuns::Case> cases = all_cases(options.quick);
    const auto outcomes = sweep<chapter07::PileOutcome>(
        options, "edge_on_edge", cases.size(), [&](std::size_t i) {
            return cases[i].pictured ? chapter07::PileOutcome{}
                                     : chapter07::watch(cases[i].scene, cases[i].duration, chapter08_solver);
        });
    if (!outcomes)
        return;
    chapter07::RestRuns runs(report, "edge_on_edge", chapter08_solver, cases.size());
    double moved = 0, gained = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        chapter07::PileOutcome outcome = (*outcomes)[i];
        if (cases[i].pictured)  // a part keeps numbers alone, and a picture needs the scene as it ended
            outcome = runs.run(cases[i]);
        else
            runs.add(cases[i], outcome);
        moved = std::max(moved, outcome.moved_mm);
        gained = std::max(gained, outcome.energy_gain_j);
    }
    runs.report("edge_on_edge", report, 2);
    report.fact("edge_on_edge", "moved_mm", moved, 2);
    report.fact("edge_on_edge", "energy_gain_j", gained, 3);
}

}  // namespace enduring::chapter08
