#include "common/experiments/report/chapter_program.hpp"
#include "common/experiments/verification/free_top.hpp"
#include "common/experiments/verification/hard_verification.hpp"
#include "common/experiments/verification/inertia_verification.hpp"
#include "common/experiments/verification/mass_verification.hpp"
#include "common/experiments/verification/modal_verification.hpp"
#include "common/experiments/verification/response_verification.hpp"
#include "common/experiments/verification/spin_verification.hpp"
#include "common/experiments/verification/static_verification.hpp"
#include "common/worked_step/worked_step.hpp"
#include "common/worked_step/worked_step_tables.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>

// Not a chapter of its own: what the pages on the base say about elastic and rigid bodies is measured here.

namespace enduring {
namespace {

void leave(Report& report, const std::string& name, const Table& table)
{
    report.table(name, table);
    report.page_table(name, table);
}

void free_top(const RunOptions&, Report& report) { report_top_drift(report); }

void lumping(const RunOptions&, Report& report) { leave(report, "lumping", verification::ways_of_lumping()); }

void cantilever(const RunOptions&, Report& report)
{
    leave(report, "cantilever", verification::cantilever());
}

/// Of the row of a kind of elements, the ratio of the sag to that of theory.
double ratio_of(const Table& table, const char* basis, const char* split, double poisson)
{
    for (const auto& row : table.rows())
        if (std::get<std::string>(row[0]) == basis && std::get<std::string>(row[1]) == split &&
            std::get<double>(row[2]) == poisson)
            return std::get<double>(row[5]);
    throw std::logic_error("locking: there is no such row");
}

void locking(const RunOptions&, Report& report)
{
    const Table table = verification::locking();
    leave(report, "locking", table);
    report.fact("locking", "six_300", ratio_of(table, "linear", "six", 0.3), 2);
    report.fact("locking", "six_450", ratio_of(table, "linear", "six", 0.45), 2);
    report.fact("locking", "six_495", ratio_of(table, "linear", "six", 0.495), 2);
    report.fact("locking", "five_450", ratio_of(table, "linear", "five", 0.45), 2);
    report.fact("locking", "quadratic_450", ratio_of(table, "quadratic", "six", 0.45), 2);
    double sideways = 0;
    for (const auto& row : table.rows())
        sideways = std::max(sideways, std::get<double>(row[6]));
    report.fact("locking", "sideways_percent", sideways, 0);
}

void frequency(const RunOptions&, Report& report)
{
    leave(report, "frequency", verification::bending_frequency());
}

void torsion(const RunOptions&, Report& report)
{
    leave(report, "torsion", verification::torsion_frequency());
}

void inertia(const RunOptions&, Report& report)
{
    leave(report, "inertia", verification::inertia_ratios());
    report.table("inertia_over_cells", verification::inertia_over_cells());
    report.plot("common/experiments/verification/plots/inertia_over_cells.gp");
}

void pushed_bar(const RunOptions&, Report& report)
{
    const Table table = verification::pushed_bar();
    leave(report, "pushed_bar", table);
    report.fact("pushed_bar", "coarse_linear_percent", std::get<double>(table.rows()[0][3]));
}

void convergence(const RunOptions&, Report& report)
{
    leave(report, "convergence_in_space", verification::convergence_in_space());
    leave(report, "convergence_in_time", verification::convergence_in_time());
}

void spinning_bar(const RunOptions&, Report& report)
{
    leave(report, "spinning_bar", verification::spinning_bar_growth());
    report.plot("common/experiments/verification/plots/spinning_bar.gp");
}

/// The largest number of a column in the rows of a law.
double most(const Table& table, const char* law, std::size_t column)
{
    double found = 0;
    for (const auto& row : table.rows())
        if (std::get<std::string>(row[1]) == law) {
            const auto* whole = std::get_if<long>(&row[column]);
            found = std::max(found, whole ? static_cast<double>(*whole) : std::get<double>(row[column]));
        }
    return found;
}

void leave_hard(Report& report, const std::string& name, const Table& table)
{
    leave(report, name, table);
    for (const ElasticLaw each :
         {ElasticLaw::corotated, ElasticLaw::corotated_at_points, ElasticLaw::neo_hookean}) {
        const char* law = verification::name_of(each);
        report.fact(name, law + std::string("_inverted"), std::max(most(table, law, 4), most(table, law, 5)));
        report.fact(name, law + std::string("_gain_j"), most(table, law, 7), 2);
    }
}

void twisted_bar(const RunOptions& options, Report& report)
{
    leave_hard(report, "twisted_bar", verification::hard_loads(verification::twist_once, options.quick));
}

void pressed_block(const RunOptions& options, Report& report)
{
    leave_hard(report, "pressed_block", verification::hard_loads(verification::press_flat, options.quick));
}

void tumbling(const RunOptions&, Report& report)
{
    const Table table = verification::tumbling_losses();
    leave(report, "tumbling", table);
    report.fact("tumbling", "one_frame_percent", most(table, "corotated", 4), 2);
    report.fact("tumbling", "at_points_percent", most(table, "corotated_at_points", 4), 1);
}

void one_worked_step(const RunOptions&, Report& report)
{
    write_worked_step(worked_step_solver(worked_step().stiffness), report);
}

}  // namespace
}  // namespace enduring

int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(
        argc, argv,
        {
            "00_base",
            "The base: elastic and rigid bodies, measured",
            {
                {"lumping", "masses of the ten-node element: row sums, and two ways that stay positive",
                 lumping},
                {"cantilever", "deflection of a clamped bar against beam theory with shear", cantilever},
                {"locking", "sag of a clamped bar over Poisson's ratio, with both bases and both cuts",
                 locking},
                {"frequency", "first bending frequency of a clamped bar against beam theory", frequency},
                {"torsion", "first torsional frequency of a clamped bar against Saint-Venant's torsion",
                 torsion},
                {"inertia", "moments of inertia of bars and bunnies, by the mass matrix and by lumped masses",
                 inertia},
                {"pushed_bar",
                 "angular momentum and work that a bar gains from a push at its edge, with each response",
                 pushed_bar},
                {"convergence", "orders in space and time", convergence},
                {"spinning_bar", "how much energy the once-a-step rotations add", spinning_bar},
                {"twisted_bar", "a clamped bar is twisted by 360 degrees and let go, of each material",
                 twisted_bar},
                {"pressed_block", "a block is pressed to 30 % of its height and let go, of each material",
                 pressed_block},
                {"tumbling", "angular momentum that a free bar loses, of each material", tumbling},
                {"free_top", "drift of a rigid body that tumbles freely, by Bullet's steps and by ours",
                 free_top},
                {"worked_step", "every array of one step after every pass, in numbers to check by hand",
                 one_worked_step},
            },
        });
}
