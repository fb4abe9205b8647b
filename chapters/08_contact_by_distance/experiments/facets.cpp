#include "chapters/08_contact_by_distance/experiments/facets.hpp"

#include "chapters/06_redefinition/experiments/rolling.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/rimless_wheel.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

using chapter06::Roll;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// m r^2 / (m r^2 + I) g sin, as RollOutcome::exact has it, solved for I.
double inertia_of(const Roll& roll, double exact)
{
    const double mr2 = roll.mass * Roll::radius * Roll::radius;
    return mr2 * (9.81 * std::sin(radians(roll.slope_deg)) / exact - 1);
}

}  // namespace

PrismRoll roll_prism(int sides, double dt)
{
    const Roll roll{.dt = dt, .sides = sides, .slope_deg = 10, .speed = 0.7, .duration = 0.5};
    chapter07::SolveStatistics solves;
    const chapter06::RollOutcome outcome = chapter06::roll(
        roll, chapter07::counting_solver(chapter08_solver, solves));
    RimlessWheel wheel{sides,
                       Roll::radius,
                       roll.mass,
                       inertia_of(roll, outcome.exact),
                       radians(roll.slope_deg),
                       0,
                       roll.speed / Roll::radius};
    PrismRoll result{outcome.surface_speed, 0, roll.speed + outcome.exact * (0.7 * roll.duration + 0.5 * dt),
                     wheel.kept(), INFINITY};
    const long steps = std::lround(roll.duration / dt), from = steps * 2 / 5;
    for (long i = 0; i < steps; ++i) {
        wheel.roll(dt);
        result.least_pressed = std::min(result.least_pressed, wheel.pressed());
        if (i >= from)
            result.by_wheel += wheel.rate * Roll::radius / static_cast<double>(steps - from);
    }
    return result;
}

namespace {

/// Prisms, whose facets are exactly those of the wheel.
void roll_prisms(bool quick, Report& report)
{
    GrowingTable table(report, "facets_prisms",
                       {"sides", "dt_s", "kept_percent", "speed_m_per_s", "wheel_m_per_s", "error_percent",
                        "round_m_per_s", "least_pressed_n"},
                       quick ? 4 : 4 * 4);
    double worst = 0, finest = 0;
    for (const int sides : {8, 16, 32, 64})
        for (const double dt : quick ? std::vector{0.0025} : std::vector{0.01, 0.005, 0.0025, 0.001}) {
            const PrismRoll roll = roll_prism(sides, dt);
            const double error = 100 * (roll.measured / roll.by_wheel - 1);
            table.add({static_cast<long>(sides), dt, 100 * roll.kept, roll.measured, roll.by_wheel, error,
                       roll.round, roll.least_pressed});
            worst = std::max(worst, std::abs(error));
            if (dt <= 0.0025)
                finest = std::max(finest, std::abs(error));
        }
    report.table("facets_prisms", table);
    report.page_table("facets_prisms", table, 4);
    report.fact("facets", "worst_percent", worst, 2);
    report.fact("facets", "short_steps_percent", finest, 2);
}

/// Balls, ever finer: what they lose against a round one.
void roll_balls(bool quick, Report& report)
{
    Table table({"faces", "dt_s", "acceleration", "round", "lost_percent"});
    const int most = quick ? 4 : 6;
    double finest = 0;
    chapter07::SolveStatistics solves;
    for (const double dt : {0.01, 0.0025})
        for (int subdivisions = 2; subdivisions <= most; ++subdivisions) {
            const Roll roll{.dt = dt, .subdivisions = subdivisions, .duration = 0.8};
            const chapter06::RollOutcome outcome = chapter06::roll(
                roll, chapter07::counting_solver(chapter08_solver, solves));
            finest = subdivisions == most
                         ? std::max(finest, std::abs(100 * (1 - outcome.acceleration / outcome.exact)))
                         : finest;
            table.add({20L << (2 * subdivisions), dt, outcome.acceleration, outcome.exact,
                       100 * (1 - outcome.acceleration / outcome.exact)});
        }
    report.table("facets_balls", table);
    report.page_table("facets_balls", table, 4);
    report.fact("facets", "finest_ball_percent", finest, 2);
}

}  // namespace

/// What flat sides cost a body that rolls.
void facets(const RunOptions& options, Report& report)
{
    roll_prisms(options.quick, report);
    roll_balls(options.quick, report);
}

}  // namespace enduring::chapter08
