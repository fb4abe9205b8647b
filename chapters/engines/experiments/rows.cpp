#include "chapters/engines/cases.hpp"
#include "chapters/engines/experiments/engines_here.hpp"
#include "chapters/engines/experiments/experiments.hpp"
#include "common/experiments/report/growing_table.hpp"

namespace enduring::engines {
namespace {

/// What is varied for the curves.
std::vector<Way> curve_ways(const Engine& engine, bool quick)
{
    std::vector<Way> ways;
    for (const int substeps : quick ? std::vector{1} : std::vector{1, 2, 4, 8}) {
        Way plain = engine.plain, best = engine.best;
        plain.substeps = best.substeps = substeps;
        ways.push_back(plain);
        if (best.fine || best.iterations > 0)
            ways.push_back(best);
    }
    return ways;
}

}  // namespace

void rows(const RunOptions& options, Report& report)
{
    GrowingTable table(
        report, "rows",
        {"scene", "engine", "version", "way", "quantity", "value", "right", "time_over_ours_by_clock"});
    const std::vector<Engine> engines = engines_here();
    long wrong = 0;
    for (const Case& asked : all_cases(options.quick)) {
        double ours_ms = 0;
        for (const Engine& engine : engines)
            for (const Way& way :
                 options.quick ? std::vector{engine.plain} : std::vector{engine.plain, engine.best}) {
                const Verdict verdict = try_case(asked, engine, way);
                if (ours_ms == 0)
                    ours_ms = verdict.ms;
                for (const Measure& measure : verdict.measures) {
                    table.add({asked.name, engine.name, engine.version, way.name, measure.quantity,
                               measure.value, measure.right ? "yes" : "no", verdict.ms / ours_ms});
                    wrong += !measure.right;
                }
            }
    }
    report.table("rows", table);
    report.fact("rows", "engines", static_cast<double>(engines.size()));
    report.fact("rows", "wrong", static_cast<double>(wrong));
}

void curves(const RunOptions& options, Report& report)
{
    GrowingTable table(
        report, "curves",
        {"scene", "engine", "way", "substeps", "quantity", "value", "right", "time_over_ours_by_clock"});
    const std::vector<Case> cases = all_cases(options.quick);
    for (const std::string name : options.quick ? std::vector{"stack"} : std::vector{"stack", "pipe_120"}) {
        double ours_ms = 0;
        for (const Engine& engine : engines_here())
            for (const Way& way : curve_ways(engine, options.quick)) {
                const Verdict verdict = try_case(case_named(cases, name), engine, way);
                if (ours_ms == 0)
                    ours_ms = verdict.ms;
                const Measure& measure = verdict.measures.front();
                table.add({name, engine.name, way.name, static_cast<long>(way.substeps), measure.quantity,
                           measure.value, measure.right ? "yes" : "no", verdict.ms / ours_ms});
            }
    }
    report.table("curves", table);
}

}  // namespace enduring::engines
