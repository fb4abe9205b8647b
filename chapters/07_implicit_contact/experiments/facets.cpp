#include "chapters/06_redefinition/experiments/rolling.hpp"
#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rimless_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter07 {
namespace {

using chapter06::Roll;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// m r^2 / (m r^2 + I) g sin, as RollOutcome::exact has it, solved for I.
double inertia_of(const Roll& roll, double exact)
{
    const double mr2 = roll.mass * Roll::radius * Roll::radius;
    return mr2 * (9.81 * std::sin(radians(roll.slope_deg)) / exact - 1);
}

/// Mean speed of the surface around the centre in the last three fifths of the run [m/s], as roll() takes it; and
/// the least force that presses an edge on [N].
struct ByWheel {
    double speed = 0, least_pressed = INFINITY;
};

ByWheel by_wheel(const Roll& roll, double inertia)
{
    RimlessWheel wheel{
        roll.sides, Roll::radius, roll.mass, inertia, radians(roll.slope_deg), 0, roll.speed / Roll::radius};
    ByWheel result;
    const long steps = std::lround(roll.duration / roll.dt), from = steps * 2 / 5;
    for (long i = 0; i < steps; ++i) {
        wheel.roll(roll.dt);
        result.least_pressed = std::min(result.least_pressed, wheel.pressed());
        if (i >= from)
            result.speed += wheel.rate * Roll::radius / static_cast<double>(steps - from);
    }
    return result;
}

/// Prisms, whose facets are exactly those of the wheel.
void roll_prisms(bool quick, Report& report)
{
    Table table({"sides", "dt_s", "kept_percent", "speed_m_per_s", "wheel_m_per_s", "error_percent",
                 "round_m_per_s", "least_pressed_n"});
    double worst = 0;
    SolveStatistics solves;
    for (const int sides : {8, 16, 32, 64})
        for (const double dt : quick ? std::vector{0.0025} : std::vector{0.01, 0.005, 0.0025, 0.001}) {
            const Roll roll{.dt = dt, .sides = sides, .slope_deg = 10, .speed = 0.7, .duration = 0.5};
            const chapter06::RollOutcome outcome = chapter06::roll(roll, counting_solver(solves));
            const double inertia = inertia_of(roll, outcome.exact);
            const ByWheel wheel = by_wheel(roll, inertia);
            const double round = roll.speed + outcome.exact * (0.7 * roll.duration + 0.5 * roll.dt),
                         error = 100 * (outcome.surface_speed / wheel.speed - 1);
            const RimlessWheel shape{sides, Roll::radius, roll.mass, inertia};
            table.add({static_cast<long>(sides), dt, 100 * shape.kept(), outcome.surface_speed, wheel.speed,
                       error, round, wheel.least_pressed});
            worst = std::max(worst, std::abs(error));
        }
    report.table("facets_prisms", table);
    report.page_table("facets_prisms", table, 4);
    report.fact("facets", "worst_percent", worst, 2);
}

/// Balls, ever finer: what they lose against a round one.
void roll_balls(bool quick, Report& report)
{
    Table table({"faces", "dt_s", "acceleration", "round", "lost_percent"});
    SolveStatistics solves;
    for (const double dt : {0.01, 0.0025})
        for (int subdivisions = 2; subdivisions <= (quick ? 4 : 6); ++subdivisions) {
            const Roll roll{.dt = dt, .subdivisions = subdivisions, .duration = 0.8};
            const chapter06::RollOutcome outcome = chapter06::roll(roll, counting_solver(solves));
            table.add({20L << (2 * subdivisions), dt, outcome.acceleration, outcome.exact,
                       100 * (1 - outcome.acceleration / outcome.exact)});
        }
    report.table("facets_balls", table);
    report.page_table("facets_balls", table, 4);
}

}  // namespace

/// What flat sides cost a body that rolls.
void facets(const RunOptions& options, Report& report)
{
    roll_prisms(options.quick, report);
    roll_balls(options.quick, report);
}

}  // namespace enduring::chapter07
