#include "chapters/04_friction/experiments/rides.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/growing_table.hpp"

namespace enduring::chapter08 {
namespace {

std::string name_of(rides::Ground ground)
{
    return ground == rides::Ground::table   ? "table"
           : ground == rides::Ground::wheel ? "wheel"
                                            : "soft slab on the table";
}

}  // namespace

/// What rides on a table that turns, or head over heels in a wheel: how far it creeps in a turn.
void turntable(const RunOptions& options, Report& report)
{
    GrowingTable table(
        report, "turntable",
        {"ground", "load", "steps_a_turn", "dt_s", "pairs", "creep_um", "slips", "unconverged", "solves"});
    double most = 0;
    for (const rides::Ground ground : {rides::Ground::table, rides::Ground::wheel, rides::Ground::soft_slab})
        for (const rides::Load load : {rides::Load::block, rides::Load::grate})
            for (const int finer : {1, 4}) {
                if (options.quick && (finer > 1 || ground == rides::Ground::soft_slab))
                    continue;
                chapter07::SolveStatistics solves;
                rides::Ride ride = rides::short_ride(ground, load);
                ride.steps = (ground == rides::Ground::wheel ? 209 : 628) * finer;
                const rides::RideRecord record = rides::take(
                    ride, chapter07::counting_solver(chapter08_solver, solves));
                const double creep = 1e6 * *std::max_element(record.creep.begin(), record.creep.end());
                table.add({name_of(ground), load == rides::Load::block ? "block" : "grate",
                           static_cast<long>(ride.steps), ride.dt(),
                           static_cast<long>(record.vertex_faces + record.edge_edges), creep,
                           record.slipped ? "yes" : "no", solves.unconverged, solves.solves});
                most = std::max(most, creep);
            }
    report.table("turntable", table);
    report.page_table("turntable", table, 2);
    report.fact("turntable", "max_um", most, 2);
}

}  // namespace enduring::chapter08
