#include "chapters/06_redefinition/experiments/levers.hpp"
#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter07 {

/// Two free blocks, one slides along the other: what they gain in momentum together. When in its step the
/// block arrives decides how far it slides in it, so three moments are tried.
void free_collision(const RunOptions&, Report& report)
{
    constexpr double down = 0.2, along = 1;  // [m/s]
    Table table(
        {"mu", "dt_s", "arrives_at", "angular_gained", "by_slide", "angular_over_dt", "linear_gained"});
    SolveStatistics solves;
    double most = 0, linear = 0, apart = 0;
    for (const double mu : {0.0, 0.3})
        for (const double dt : {0.01, 0.001})
            for (const double arrives : {0.1, 0.5, 0.9}) {
                const chapter06::FreeSlide slide{dt, along, arrives * down * dt,
                                                 MassSplitting{.mu_s = mu, .mu_d = mu}};
                const chapter06::LeverCost cost = chapter06::cost_of_levers(
                    slide, counting_solver(chapter07_solver, solves));
                const double gained = cost.measured.norm();
                const double pressed = cost.pushed / std::sqrt(1 + mu * mu);
                const double by_slide = pressed * along * dt * arrives * (1 - arrives);
                table.add({mu, dt, arrives, gained, by_slide, gained / dt, cost.linear.norm()});
                most = std::max(most, gained / dt);
                linear = std::max(linear, cost.linear.norm());
                apart = std::max(apart, std::abs(gained / by_slide - 1));
            }
    report.table("free_collision", table);
    report.page_table("free_collision", table, 2);
    report.fact("free_collision", "max_over_dt", most, 2);
    report.fact("free_collision", "linear", linear, 1);
    report.fact("free_collision", "apart_percent", 100 * apart, 2);
}

}  // namespace enduring::chapter07
