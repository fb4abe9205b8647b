#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/13_other_solvers/experiments/experiments.hpp"
#include "chapters/13_other_solvers/experiments/method_table.hpp"
#include "chapters/13_other_solvers/solver.hpp"
#include "chapters/engines/cases.hpp"
#include "chapters/engines/experiments/measured_rows.hpp"
#include "chapters/engines/judge.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/input/input_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace enduring::chapter13 {
namespace {

using namespace engines;

/// A column of the table: who steps the scenes.
struct Column {
    std::string title;
    Engine engine;
    bool knows_restitution = false;  ///< of a scene
    bool is_method = false;          ///< of this chapter
};

Column column_of(const OtherMethod& method)
{
    Engine engine{method.title, "", "", "", {"default"}, {"default"}, {}};
    engine.run = [make = method.make](Scene scene, const Way&, int steps) {
        return run_solver(std::move(scene), 1, steps, [&](Scene& taken) { return make(taken.contact); });
    };
    return {method.title, engine, method.knows_restitution, true};
}

std::vector<Column> all_columns()
{
    std::vector<Column> columns;
    for (const OtherMethod& method : other_methods())
        columns.push_back(column_of(method));
    columns.push_back({"chapter 10", chapter10_engine(), true});
    columns.push_back({"chapter 11", chapter11_engine(), true});
    for (const Engine& engine : {bullet_engine(), mujoco_engine()})
        if (engine.is_here())
            columns.push_back({engine.name, engine, false});  // the page on engines hands no restitution over
    return columns;
}

//! [bounce]
/// A cube falls on its corner, below its centre: one contact, so that Newton's rule has one answer.
Case bounce()
{
    const auto make = [](int) {
        const double upright = std::acos(1 / std::sqrt(3.0)) * 180 / std::numbers::pi;
        Scene scene = chapter07::scene_of(
            {{10, Vec3(0, std::sqrt(0.75) + 0.5, 0), upright, Vec3(-1, 0, 1).normalized()}}, 0.01);
        scene.world.restitution.between = {0.6};
        scene.name = "bounce";
        scene.duration = 0.6;
        return scene;
    };
    return {"bounce", "a cube falls on its corner: what part of its speed comes back?", 1, make,
            [](int, const EngineScene& scene, const Trajectory& run) {
                const double kept = thrown_m_per_s(scene, run) / std::sqrt(2 * 9.81 * 0.5);
                return std::vector<Measure>{{"kept_of_0.6", kept, std::abs(kept - 0.6) < 0.05}};
            }};
}
//! [bounce]

Case cards()
{
    return {"cards", "a card house of three levels: how far does a card move?", 1,
            [](int) {
                Scene scene = chapter07::scene_of(chapter07::card_house(3, 15), 0.01);
                scene.name = "cards";
                scene.duration = 3;
                return scene;
            },
            [](int, const EngineScene&, const Trajectory& run) {
                const double moved = moved_mm(run);
                return std::vector<Measure>{{"moved_mm", moved, moved < 10}};
            }};
}

std::vector<Case> cases_of(bool quick)
{
    const std::vector<Case> theirs = all_cases(quick);
    std::vector<Case> cases;
    for (const std::string name : {"slopes", "stack", "overlap", "ratio_1000", "arch", "thin"})
        for (const Case& one : theirs)
            if (one.name == name)
                cases.push_back(one);
    cases.push_back(bounce());
    if (!quick)
        cases.push_back(cards());
    return cases;
}

/// Why a method has no answer; empty if it has: restitution is not in every paper, and a barrier cannot begin
/// inside.
std::string refusal_of(const Case& asked, const Column& column)
{
    if (asked.name == "bounce" && !column.knows_restitution)
        return column.is_method ? "there is no restitution in its papers"
                                : "the page on engines passes no restitution on";
    if (column.is_method)
        try {
            column.engine.run(asked.make(0), column.engine.plain, 1);
        } catch (const InputError& refusal) {
            return refusal.what();
        }
    return {};
}

}  // namespace

/// Each scene under each method with its paper's defaults, under ours and under the engines of the same kind.
void same_scenes(const RunOptions& options, Report& report)
{
    const std::vector<Column> columns = all_columns();
    std::vector<std::string> head{"scene", "measured"};
    for (const Column& column : columns)
        head.push_back(column.title);
    Table page(head);
    GrowingTable table(report, "same_scenes",
                       {"scene", "method", "quantity", "value", "right", "time_over_ours_by_clock"});
    std::vector<long> right(columns.size(), 0);
    std::vector<Refusal> refusals;
    long asked_of_each = 0;
    for (const Case& asked : cases_of(options.quick)) {
        std::vector<std::vector<Cell>> lines;
        std::vector<Verdict> verdicts;
        for (const Column& column : columns) {
            const std::string reason = refusal_of(asked, column);
            if (!reason.empty())
                refusals.push_back({asked.name, column.title, reason});
            verdicts.push_back(reason.empty() ? try_case(asked, column.engine, column.engine.plain)
                                              : Verdict{});
        }
        const auto ours =
            static_cast<std::size_t>(std::find_if(columns.begin(), columns.end(),
                                                  [](const Column& c) { return c.title == "chapter 10"; }) -
                                     columns.begin());
        for (std::size_t m = 0; m < verdicts[ours].measures.size(); ++m) {
            std::vector<Cell> line{asked.name, with_unit(verdicts[ours].measures[m].quantity)};
            for (std::size_t i = 0; i < columns.size(); ++i) {
                if (verdicts[i].measures.empty()) {
                    line.emplace_back("not defined");
                    continue;
                }
                const Measure& measure = verdicts[i].measures[m];
                line.emplace_back(cell_of(measure.value, measure.right));
                right[i] += measure.right;
                report.fact("same_scenes",
                            asked.name + "_" + fact_word(columns[i].title) + "_" + measure.quantity,
                            measure.value);
                const double ratio = verdicts[i].ms / verdicts[ours].ms;  // of a short run: no number
                table.add({asked.name, columns[i].title, measure.quantity, measure.value,
                           measure.right ? "yes" : "no", std::isfinite(ratio) ? Cell(ratio) : Cell("")});
            }
            ++asked_of_each;
            page.add(line);
        }
    }
    report.table("same_scenes", table);
    report.page_table("same_scenes", page);
    report_refusals(report, "same_scenes", refusals);
    report.fact("same_scenes", "asked", static_cast<double>(asked_of_each));
    for (std::size_t i = 0; i < columns.size(); ++i)
        report.fact("same_scenes", fact_word(columns[i].title) + "_right", static_cast<double>(right[i]));
}

}  // namespace enduring::chapter13
