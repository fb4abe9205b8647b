#include "chapters/08_speculative_contacts/experiments/forces.hpp"

#include "chapters/08_speculative_contacts/experiments/experiments.hpp"
#include "chapters/08_speculative_contacts/experiments/forces_frames.hpp"
#include "chapters/08_speculative_contacts/experiments/forces_impacts.hpp"
#include "chapters/08_speculative_contacts/experiments/forces_landing.hpp"
#include "chapters/08_speculative_contacts/experiments/forces_soft.hpp"
#include "chapters/08_speculative_contacts/experiments/forces_statics.hpp"
#include "chapters/08_speculative_contacts/experiments/forces_vices.hpp"
#include "chapters/08_speculative_contacts/solver.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <string>
#include <vector>

namespace enduring::chapter08 {

const std::vector<force_rows::Kind>& force_rows::all_kinds()
{
    static const std::vector<Kind> kinds{
        weights,       tables, mirror_images, piles,          slopes,
        wedges,        frames, arches,        chains,         soft_weights,
        soft_pressure, hertz,  either_order,  straight_drops, momentum_of_impacts,
        landings,      vices,  grippers};
    return kinds;
}

/// Forces of pairs against statics and formulas, a row a kind.
void forces(const RunOptions& options, Report& report)
{
    const force_rows::MakeSolver make = [](const ContactParameters& parameters) {
        ImplicitSettings settings;
        settings.record = [](const SolveRecord&) {};  // a row tells what is not solved
        return chapter08_solver(parameters, settings);
    };
    GrowingTable table(
        report, "forces",
        {"scene", "quantity", "formula", "runs", "off", "allowed", "unit", "holds", "worst run"});
    Table page({"scene", "quantity", "formula", "runs", "off", "allowed", "unit"});
    double hold = 0, runs = 0;
    std::string failing;
    for (const force_rows::Kind& kind : force_rows::all_kinds())
        for (const force_rows::Row& row : kind(make, !options.quick)) {
            table.add({row.scene, row.quantity, row.formula, row.runs, row.off, row.allowed, row.unit,
                       std::string(row.holds() ? "yes" : "no"), row.worst});
            page.add({row.scene, row.quantity, row.formula, row.runs, row.off, row.allowed, row.unit});
            report.fact("forces", row.key, row.off, 2);
            report.fact("forces", row.key + "_worst", row.worst);
            hold += row.holds();
            runs += static_cast<double>(row.runs);
            if (!row.holds())
                failing += (failing.empty() ? "" : "; ") + row.key;
        }
    report.table("forces", table);
    report.page_table("forces", page, 2);
    report.fact("forces", "rows", static_cast<double>(page.rows().size()));
    report.fact("forces", "runs", runs);
    report.fact("forces", "hold", hold);
    report.fact("forces", "failing", failing.empty() ? "none" : failing);
}

}  // namespace enduring::chapter08
