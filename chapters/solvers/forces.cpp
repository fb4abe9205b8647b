#include "chapters/08_contact_by_distance/experiments/forces.hpp"

#include "chapters/08_contact_by_distance/experiments/forces_frames.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_impacts.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_landing.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_statics.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_vices.hpp"
#include "chapters/solvers/chapter_solver.hpp"
#include "chapters/solvers/experiments.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <array>
#include <string>
#include <vector>

namespace enduring::solvers {

using chapter08::force_rows::Kind;
using chapter08::force_rows::MakeSolver;
using chapter08::force_rows::Row;
using chapter08::force_rows::Rows;

namespace {

MakeSolver quiet_solver(int chapter)
{
    return [chapter](const ContactParameters& parameters) {
        ImplicitSettings settings;
        settings.record = [](const SolveRecord&) {};  // a row tells what is not solved
        return chapter_solver(chapter, parameters, settings);
    };
}

}  // namespace

/// The rows of chapter 8's experiment on forces under each solver that answers all pairs together.
void forces(const RunOptions& options, Report& report)
{
    namespace rows = chapter08::force_rows;
    const std::vector<Kind> few{rows::tables, rows::wedges, rows::either_order, rows::straight_drops};
    std::vector<Kind> kinds = few;
    if (!options.quick) {
        kinds = rows::all_kinds();
        kinds.insert(kinds.end(), rows::squeezed_kinds().begin(), rows::squeezed_kinds().end());
    }
    constexpr std::array solvers{8, 9, 10, 11};
    GrowingTable table(report, "forces_of_chapters",
                       {"chapter", "scene", "quantity", "off", "allowed", "unit", "holds", "worst run"});
    std::array<Rows, solvers.size()> of_chapter;
    for (std::size_t i = 0; i < solvers.size(); ++i) {
        double hold = 0;
        std::string failing;
        for (const Kind& kind : kinds)
            for (const Row& row : kind(quiet_solver(solvers[i]), false)) {
                of_chapter[i].push_back(row);
                table.add({static_cast<long>(solvers[i]), row.scene, row.quantity, row.off, row.allowed,
                           row.unit, std::string(row.holds() ? "yes" : "no"), row.worst});
                hold += row.holds();
                if (!row.holds())
                    failing += (failing.empty() ? "" : "; ") + row.key;
            }
        const std::string name = "chapter_" + std::to_string(solvers[i]);
        report.fact("forces_of_chapters", name + "_hold", hold);
        report.fact("forces_of_chapters", name + "_failing", failing.empty() ? "none" : failing);
    }
    report.table("forces_of_chapters", table);
    report.fact("forces_of_chapters", "rows", static_cast<double>(of_chapter[0].size()));
    Table page(
        {"scene", "quantity", "chapter 8", "chapter 9", "chapter 10", "chapter 11", "allowed", "unit"});
    for (std::size_t row = 0; row < of_chapter[0].size(); ++row) {
        const Row& first = of_chapter[0][row];
        page.add({first.scene, first.quantity, first.off, of_chapter[1][row].off, of_chapter[2][row].off,
                  of_chapter[3][row].off, first.allowed, first.unit});
    }
    report.page_table("forces_of_chapters", page, 2);
}

}  // namespace enduring::solvers
