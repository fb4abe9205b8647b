#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/01_particle_plane/experiments/experiments.hpp"
#include "chapters/01_particle_plane/settling.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter01 {
namespace {

double highest_at_the_end(PenaltyMethod method, double times_limit)
{
    ParticleProblem problem;
    problem.method = method;
    problem.dt = times_limit * enduring::critical_step(method, problem.mass, problem.stiffness);
    const std::vector<double> heights = last_heights(problem);
    return *std::max_element(heights.begin(), heights.end());
}

/// What a search for blow-up would see.
Table beyond_limit()
{
    Table table({"times_limit", "dpf_m", "cpf_m"});
    for (const double times : {0.99, 1.01, 1.1, 1.25, 1.5, 2.0})
        table.add({times, highest_at_the_end(PenaltyMethod::discrete, times),
                   highest_at_the_end(PenaltyMethod::continuous, times)});
    return table;
}

}  // namespace

/// The particle of thesis figure 7.1; the largest step with which it settles, beside the analytic one.
void critical_step(const RunOptions&, Report& report)
{
    Table table({"method", "analytic", "measured"});
    double measured_of[2] = {0, 0};
    for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous}) {
        ParticleProblem problem;
        problem.method = method;
        const double analytic = enduring::critical_step(method, problem.mass, problem.stiffness);
        const double measured = measured_critical_step(problem, 0.5 * analytic, 1.5 * analytic, 1e-5);
        table.add({short_name(method), analytic, measured});

        const std::string name = method == PenaltyMethod::discrete ? "dpf" : "cpf";
        report.fact("critical_step", name + "_analytic", analytic, 4);
        report.fact("critical_step", name + "_measured", measured, 4);
        report.fact("critical_step", name + "_error_percent", 100 * std::abs(measured / analytic - 1), 1);
        measured_of[method == PenaltyMethod::discrete ? 0 : 1] = measured;
    }
    report.table("critical_step", table);
    report.page_table("critical_step", table, 5);
    report.table("beyond_limit", beyond_limit());
    report.page_table("beyond_limit", beyond_limit());
    report.fact("critical_step", "ratio_analytic", std::sqrt(1.5), 5);
    report.fact("critical_step", "ratio_measured", measured_of[1] / measured_of[0], 5);
}

}  // namespace enduring::chapter01
