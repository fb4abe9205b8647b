#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/13_other_solvers/experiments/experiments.hpp"
#include "chapters/13_other_solvers/experiments/watched_run.hpp"
#include "chapters/13_other_solvers/solver.hpp"
#include "chapters/engines/experiments/measured_rows.hpp"
#include "common/experiments/report/statistics.hpp"
#include "common/experiments/report/sweep.hpp"
#include "common/input/number_text.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace enduring::chapter13 {
namespace {

using engines::fact_word;

/// A row of a method in a scene, its page and its facts. A run that was left says so, and has no verdict.
struct CrowdRow {
    std::string experiment, title;
    WatchedRun run;
    double asked_s, budget_s;

    bool has_ended() const { return run.reached_s > asked_s - 1e-9; }
    void add_to(Table& page, Table& table, double deep_mm, double slow_mm_per_s) const
    {
        std::vector<Cell> line{title};
        if (!run.is_defined()) {
            line.resize(6, "not defined");
            page.add(line);
            return;
        }
        line.emplace_back(cell_of(run.deepest_mm, run.deepest_mm < deep_mm));
        line.emplace_back(cell_of(run.deepest_end_mm, run.deepest_end_mm < deep_mm));
        line.emplace_back(has_ended() ? cell_of(run.drift_mm_per_s, run.drift_mm_per_s < slow_mm_per_s)
                                      : "not in " + readable(budget_s, 3) + " s: at " +
                                            readable(run.reached_s, 2) + " s");
        line.emplace_back(cell_of(run.gained_j, run.gained_j < 0.01 * run.lost_j));
        line.emplace_back(readable(run.step_ms, 3));
        page.add(line);
        table.add({title, run.deepest_mm, run.deepest_end_mm, run.drift_mm_per_s, run.gained_j, run.reached_s,
                   run.step_ms});
    }
    void tell(Report& report) const
    {
        if (!run.is_defined())
            return;
        const std::string word = fact_word(title);
        report.fact(experiment, word + "_deepest_mm", run.deepest_mm);
        report.fact(experiment, word + "_end_mm", run.deepest_end_mm);
        report.fact(experiment, word + "_drift_mm_per_s", run.drift_mm_per_s);
        report.fact(experiment, word + "_gained_J", run.gained_j);
        report.fact(experiment, word + "_ms_by_clock", run.step_ms);
        report.fact(experiment, word + "_reached_s", run.reached_s, 2);
    }
};

/// One scene under some columns: tables NAME and NAME_not_defined.
void report_crowd(const RunOptions& options, Report& report, const std::string& name,
                  const std::vector<Answering>& columns, const Watch& watch, double deep_mm,
                  double slow_mm_per_s, const std::function<Scene()>& make)
{
    const auto found = sweep<WatchedRun>(options, name, columns.size(), [&](std::size_t i) {
        return watch_run(make(), columns[i].make, watch);
    });
    if (!found)
        return;
    Table page({"method", "deepest [mm]", "at the end [mm]", "drift at the end [mm/s]", "energy gained [J]",
                "ms a step"});
    Table table(
        {"method", "deepest_mm", "end_mm", "drift_mm_per_s", "gained_j", "reached_s", "step_ms_by_clock"});
    std::vector<Refusal> refusals;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const CrowdRow row{name, columns[i].title, (*found)[i], watch.seconds, watch.budget_s};
        row.add_to(page, table, deep_mm, slow_mm_per_s);
        row.tell(report);
        if (!row.run.is_defined())
            refusals.push_back({name, row.title, row.run.reason.data()});
    }
    report.table(name, table);
    report.page_table(name, page);
    if (!refusals.empty())
        report_refusals(report, name, refusals);
}

}  // namespace

//! [heap]
/// Cubes, turned at random, fall from a lattice onto the ground and on one another.
void heap(const RunOptions& options, Report& report)
{
    const int cubes = options.quick ? 8 : 30, side = options.quick ? 2 : 3;
    const Watch watch{options.quick ? 3.0 : 8.0, 0, options.quick ? 60.0 : 120.0, 5};
    report_crowd(options, report, "heap", all_answering(), watch, 1, 1,
                 [&] { return chapter07::scene_of(chapter07::loose_cubes(cubes, side, 1), 0.01); });
}
//! [heap]

/// A soft bunny without damping falls into a rigid bowl that falls on the ground.
void bunny_bowl(const RunOptions& options, Report& report)
{
    const Watch watch{options.quick ? 0.7 : 3.0, 0, options.quick ? 60.0 : 300.0, 1};
    report_crowd(options, report, "bunny_bowl", all_answering(), watch, 5, INFINITY, [] {
        return load_scene(scene_file("bunny_bowl"),
                          R"({"/bodies/bunny/rayleigh": {"mass": 0, "stiffness": 0}})");
    });
}

namespace {

/// The slope of the logarithms from the first to the last count that a method has.
double exponent_of(const std::vector<std::pair<int, double>>& curve)
{
    const auto& [n_0, ms_0] = curve.front();
    const auto& [n_1, ms_1] = curve.back();
    return growth_power(n_0, ms_0, n_1, ms_1);
}

}  // namespace

/// Three layers of cubes fall on one another: the time of a step over their number, when all have landed.
void growth(const RunOptions& options, Report& report)
{
    const std::vector<int> sides = options.quick ? std::vector{1, 2} : std::vector{2, 3, 6, 10, 18};
    const std::vector<Answering>& columns = all_answering();
    const Watch watch{1.3, 1, 60, 0};
    const auto found = sweep<WatchedRun>(
        options, "growth", columns.size() * sides.size(), [&](std::size_t i) {
            const int side = sides[i % sides.size()];
            return watch_run(chapter07::scene_of(chapter07::loose_cubes(3 * side * side, side, 1), 0.01),
                             columns[i / sides.size()].make, watch);
        });
    if (!found)
        return;
    std::vector<std::string> head{"method"};
    for (const int side : sides)
        head.push_back(std::to_string(3 * side * side) + " cubes [ms]");
    head.emplace_back("exponent");
    Table page(head), table({"method", "cubes", "step_ms_by_clock"});
    for (std::size_t c = 0; c < columns.size(); ++c) {
        std::vector<Cell> line{columns[c].title};
        std::vector<std::pair<int, double>> curve;
        for (std::size_t s = 0; s < sides.size(); ++s) {
            const WatchedRun& run = (*found)[c * sides.size() + s];
            const int cubes = 3 * sides[s] * sides[s];
            if (run.reached_s < watch.seconds - 1e-9) {
                line.emplace_back("not in " + readable(watch.budget_s, 3) + " s");
                continue;
            }
            curve.emplace_back(cubes, run.step_ms);
            line.emplace_back(readable(run.step_ms, 3));
            table.add({columns[c].title, static_cast<long>(cubes), run.step_ms});
        }
        const double exponent = curve.size() < 2 ? NAN : exponent_of(curve);
        line.emplace_back(std::isfinite(exponent) ? readable(exponent, 2) : "-");
        page.add(line);
        if (std::isfinite(exponent))
            report.fact("growth", fact_word(columns[c].title) + "_exponent_by_clock", exponent, 2);
    }
    report.table("growth", table);
    report.page_table("growth", page);
    report.plot("chapters/13_other_solvers/plots/growth.gp");
}

}  // namespace enduring::chapter13
