#include "chapters/08_contact_by_distance/experiments/forces.hpp"

#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_frames.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_impacts.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_landing.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_soft.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_statics.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_vices.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <string>
#include <vector>

namespace enduring::chapter08 {

const std::vector<force_rows::Kind>& force_rows::all_kinds()
{
    static const std::vector<Kind> kinds{
        weights,       tables,      mirror_images, piles,          slopes,
        wedges,        frames,      arches,        chains,         soft_weights,
        soft_pressure, hertz,       either_order,  straight_drops, momentum_of_impacts,
        landings,      rods_on_end, struck_balls};
    return kinds;
}

const std::vector<force_rows::Kind>& force_rows::squeezed_kinds()
{
    static const std::vector<Kind> kinds{vices, grippers};
    return kinds;
}

void force_rows::report_rows(Report& report, const std::string& name, const std::vector<Kind>& kinds,
                             const MakeSolver& make, bool full)
{
    GrowingTable table(
        report, name,
        {"scene", "quantity", "formula", "runs", "off", "allowed", "unit", "holds", "worst run"});
    Table page({"scene", "quantity", "formula", "runs", "off", "allowed", "unit"});
    double hold = 0, runs = 0;
    std::string failing;
    for (const Kind& kind : kinds)
        for (const Row& row : kind(make, full)) {
            table.add({row.scene, row.quantity, row.formula, row.runs, row.off, row.allowed, row.unit,
                       std::string(row.holds() ? "yes" : "no"), row.worst});
            page.add({row.scene, row.quantity, row.formula, row.runs, row.off, row.allowed, row.unit});
            report.fact(name, row.key, row.off, 2);
            report.fact(name, row.key + "_worst", row.worst);
            hold += row.holds();
            runs += static_cast<double>(row.runs);
            if (!row.holds())
                failing += (failing.empty() ? "" : "; ") + row.key;
        }
    report.table(name, table);
    report.page_table(name, page, 2);
    report.fact(name, "rows", static_cast<double>(page.rows().size()));
    report.fact(name, "runs", runs);
    report.fact(name, "hold", hold);
    report.fact(name, "failing", failing.empty() ? "none" : failing);
}

/// Forces of pairs against statics and formulas, a row a kind.
void forces(const RunOptions& options, Report& report)
{
    const force_rows::MakeSolver make = [](const ContactParameters& parameters) {
        ImplicitSettings settings;
        settings.record = [](const SolveRecord&) {};  // a row tells what is not solved
        return chapter08_solver(parameters, settings);
    };
    force_rows::report_rows(report, "forces", force_rows::all_kinds(), make, !options.quick);
}

}  // namespace enduring::chapter08
