#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/engines/cases.hpp"
#include "chapters/engines/experiments/engines_here.hpp"
#include "chapters/engines/experiments/experiments.hpp"
#include "chapters/engines/judge.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/experiments/report/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace enduring::engines {
namespace {

constexpr int frames = 40;        ///< of 1/60 s
constexpr double patience = 250;  ///< a run that would take longer by its engine's last two is left out [s]

/// A wall of cubes of 1 m that stands in touch: in each row one cube less than in the row below, 10 cm apart.
/// It should stay as it is.
Case pyramid(int base)
{
    const auto make = [=](int) {
        std::vector<chapter07::Box> cubes;
        for (int row = 0; row < base; ++row)
            for (int column = 0; column < base - row; ++column)
                cubes.push_back({.centre = Vec3(1.1 * column + 0.55 * row, row + 0.5, 0)});
        Scene scene = chapter07::scene_of(cubes, 1.0 / 60);
        scene.name = "pyramid";
        scene.duration = frames * scene.dt;
        return scene;
    };
    return {
        "pyramid", "a pyramid of cubes: how far does one move in two thirds of a second?", 1, make,
        [](int, const EngineScene& scene, const Trajectory& run) {
            const double moved = moved_mm(run), depth = depth_um(scene, run.back());
            return std::vector<Measure>{{"moved_mm", moved, moved < 10}, {"depth_um", depth, depth < 1000}};
        }};
}

int cubes_of(int base) { return base * (base + 1) / 2; }

/// The time that a run would take if it grew from run to run by the same power [s]. A direct solver grows by
/// the third.
double expected_seconds(const std::vector<int>& bodies, const std::vector<double>& ms, int next)
{
    if (ms.empty())
        return 0;
    double power = 3;
    if (ms.size() > 1)
        power = growth_power(bodies[ms.size() - 2], ms[ms.size() - 2], bodies[ms.size() - 1], ms.back());
    return 1e-3 * frames * ms.back() * std::pow(static_cast<double>(next) / bodies[ms.size() - 1], power);
}

}  // namespace

void growth(const RunOptions& options, Report& report)
{
    GrowingTable table(report, "growth",
                       {"bodies", "engine", "way", "quantity", "value", "right", "time_over_ours_by_clock"});
    const std::vector<int> bases = options.quick ? std::vector{5, 8} : std::vector{14, 24, 44, 77, 100};
    std::vector<int> bodies;
    for (const int base : bases)
        bodies.push_back(cubes_of(base));
    double ours_ms = 0;  // of chapter 10 with the fewest bodies
    for (const Engine& engine : engines_here()) {
        std::vector<double> default_ms;
        for (const Way& way :
             options.quick ? std::vector{engine.plain} : std::vector{engine.plain, engine.best}) {
            std::vector<double> ms;
            for (std::size_t i = 0; i < bases.size(); ++i) {
                // the best settings take no less than the default ones
                const double at_least = i < default_ms.size() ? 1e-3 * frames * default_ms[i] : 0;
                if (std::max(at_least, expected_seconds(bodies, ms, bodies[i])) > patience)
                    break;
                const Verdict verdict = try_case(pyramid(bases[i]), engine, way);
                ms.push_back(verdict.ms);
                if (ours_ms == 0)
                    ours_ms = verdict.ms;
                for (const Measure& measure : verdict.measures)
                    table.add({static_cast<long>(bodies[i]), engine.name, way.name, measure.quantity,
                               measure.value, measure.right ? "yes" : "no", verdict.ms / ours_ms});
                if (verdict.ms == 0)
                    break;  // it failed
            }
            if (default_ms.empty())
                default_ms = ms;
        }
    }
    report.table("growth", table);
}

}  // namespace enduring::engines
