#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/solvers/experiments.hpp"
#include "common/experiments/report/statistics.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/simulation/energy.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace enduring::solvers {
namespace {

constexpr double dense = std::numeric_limits<double>::infinity();

/// Of 2 m and 10 kg, which falls flat from 20 cm.
Scene wide_mat(int cells)
{
    return chapter07::falling_mat(
        2, cells,
        {{"mass", 10}, {"position", {0, 0.2, 0}}, {"rotation", {{"axis", {1, 0, 0.3}}, {"angle_deg", 8}}}});
}

struct MatRun {
    double flat_ms = 0;       ///< processor time of each of the last five steps
    double newton_steps = 0;  ///< of each of them
    long pairs = 0;
    double energy = 0;  ///< in the end [J]
};

MatRun run_mat(int cells, double sparse_operation)
{
    constexpr int last = 5;
    Scene scene = wide_mat(cells);
    ImplicitSettings settings;
    settings.threads = 1;
    settings.sparse_operation = sparse_operation;
    long newton_steps = 0;
    settings.record = [&](const SolveRecord& record) { newton_steps += record.newton_steps; };
    const Solver solver = chapter08_solver(scene.contact, settings);
    Contacts contacts;
    const int falls = static_cast<int>(std::lround(scene.duration / scene.dt)) - last;
    for (int i = 0; i < falls; ++i)
        advance(scene.world, contacts, solver, scene.dt);
    newton_steps = 0;
    const double start = processor_seconds();
    for (int i = 0; i < last; ++i)
        advance(scene.world, contacts, solver, scene.dt);
    return {1000 * (processor_seconds() - start) / last, static_cast<double>(newton_steps) / last,
            static_cast<long>(contacts.size()), total_energy(scene.world).total()};
}

/// The exponent of the time over the pairs.
double exponent(const MatRun& first, const MatRun& last)
{
    return growth_power(static_cast<double>(first.pairs), first.flat_ms, static_cast<double>(last.pairs),
                        last.flat_ms);
}

}  // namespace

void soft_speed(const RunOptions& options, Report& report)
{
    Table table({"cells", "pairs", "dense [ms]", "with all nodes [ms]", "Newton steps, dense",
                 "Newton steps, with all nodes", "energy, dense [J]", "energy, with all nodes [J]"});
    std::vector<MatRun> before, after;
    const std::vector<int> dense_cells = options.quick ? std::vector{3, 4} : std::vector{8, 10, 12};
    for (const int cells : dense_cells) {
        before.push_back(run_mat(cells, dense));
        after.push_back(run_mat(cells, ImplicitSettings{}.sparse_operation));
        table.add({static_cast<long>(cells), after.back().pairs, before.back().flat_ms, after.back().flat_ms,
                   before.back().newton_steps, after.back().newton_steps, before.back().energy,
                   after.back().energy});
    }
    report.fact("soft_speed", "gain_by_clock", before.back().flat_ms / after.back().flat_ms, 2);
    if (!options.quick) {
        after.push_back(run_mat(20, ImplicitSettings{}.sparse_operation));
        table.add({20L, after.back().pairs, "", after.back().flat_ms, "", after.back().newton_steps, "",
                   after.back().energy});
    }
    report.fact("soft_speed", "exponent_by_clock", exponent(after.front(), after.back()), 2);
    report.fact("soft_speed", "dense_exponent_by_clock", exponent(before.front(), before.back()), 2);
    report.table("soft_speed", table);
    report.page_table("soft_speed", table, 3);
}

}  // namespace enduring::solvers
