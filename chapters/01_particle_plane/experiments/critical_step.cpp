#include "experiments.hpp"

#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/01_particle_plane/settling.hpp"

#include <cmath>

namespace enduring::chapter01 {

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
    report.fact("critical_step", "ratio_analytic", std::sqrt(1.5), 5);
    report.fact("critical_step", "ratio_measured", measured_of[1] / measured_of[0], 5);
}

}  // namespace enduring::chapter01
