#include "chapters/08_contact_by_distance/experiments/driven_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/euler_disk.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/facets.hpp"
#include "chapters/08_contact_by_distance/experiments/gears.hpp"
#include "chapters/08_contact_by_distance/experiments/sphere_impacts.hpp"
#include "chapters/08_contact_by_distance/experiments/swings.hpp"
#include "chapters/08_contact_by_distance/experiments/tops.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace enduring::chapter08 {
namespace {

/// A motion whose formula is known.
struct Law {
    std::string name, quantity;
    std::function<double(double dt)> error;  ///< relative, without its sign
};

double off(const AgainstFormula& found) { return std::abs(found.error()); }

double swing_off(double dt, bool period)
{
    Swing swing = block_in_pipe(120, dt);
    const SwingOutcome outcome = watch_swing(swing);
    const double mean = 0.5 * swing.amplitude * (1 + outcome.kept);
    return period ? off({outcome.period_s, pendulum_period(swing, mean)})
                  : off({outcome.kept, inelastic_bound(swing)});
}

std::vector<Law> all_laws()
{
    return {
        {"ball that strikes and sticks", "velocities",
         [](double dt) { return strike({.along = 0.5, .dt = dt, .subdivisions = 5}).largest_off; }},
        {"ball that strikes and slides", "velocities",
         [](double dt) { return strike({.along = 4, .dt = dt, .subdivisions = 5}).largest_off; }},
        {"two balls that strike", "velocities",
         [](double dt) {
             return strike({.spin = 5, .other_radius = 0.1, .dt = dt, .subdivisions = 5}).largest_off;
         }},
        {"ball that slides and then rolls", "time of its slip",
         [](double dt) { return off(slide_to_roll(dt, 4).time); }},
        {"prism rolls down", "mean speed",
         [](double dt) {
             const PrismRoll roll = roll_prism(32, dt);
             return off({roll.measured, roll.by_wheel});
         }},
        {"block slides down", "acceleration", [](double dt) { return off(slide_of_materials(30, dt)); }},
        {"pushed puck", "distance", [](double dt) { return off(pushed_puck(dt)); }},
        {"block on a belt", "distance slid", [](double dt) { return off(conveyor(dt).slid); }},
        {"wheel with a torque", "speed", [](double dt) { return off(torque_on_wheel(dt)); }},
        {"top on its tip", "precession",
         [](double dt) {
             const Precession found = spin_top({.spin = 100, .lean_deg = 20, .dt = dt}, 1);
             return off({found.rate, found.by_formula});
         }},
        {"Euler's disk", "precession",
         [](double dt) {
             const DiskRun run = spin_disk({.sides = 192, .dt = dt}, 0.2);
             return off({run.rate, run.by_formula});
         }},
        {"block in a half pipe", "amplitude kept", [](double dt) { return swing_off(dt, false); }},
        {"the same block", "period", [](double dt) { return swing_off(dt, true); }},
        {"gear pair", "acceleration",
         [](double dt) {
             const GearRun run = turn_gears({.dt = dt}, 0.5);
             return off({run.acceleration, run.by_formula});
         }},
    };
}

constexpr double exact_below = 1e-6;  ///< a relative error that no longer depends on the step: of the solve

/// Power of the step with which an error falls, by least squares of logarithms.
double order_of(const std::vector<double>& steps, const std::vector<double>& errors)
{
    double n = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double x = std::log(steps[i]), y = std::log(std::max(errors[i], 1e-12));
        n += 1;
        x_sum += x;
        y_sum += y;
        xx += x * x;
        xy += x * y;
    }
    return (n * xy - x_sum * y_sum) / (n * xx - x_sum * x_sum);
}

std::string column_of(double dt)
{
    std::ostringstream name;
    name << "error at " << 1000 * dt << " ms [%]";
    return name.str();
}

}  // namespace

/// Motions with a formula, all of them over the step: whose error falls?
void formulas(const RunOptions& options, Report& report)
{
    const std::vector<double> steps = options.quick ? std::vector{0.01, 0.005, 0.0025}
                                                    : std::vector{0.01, 0.005, 0.0025, 0.00125, 0.000625};
    std::vector<std::string> columns{"motion", "quantity"}, curves{"dt_s"};
    for (const double dt : steps)
        columns.push_back(column_of(dt));
    columns.insert(columns.end(), {"order", "falls"});
    const std::vector<Law> laws = all_laws();
    GrowingTable table(report, "formulas", columns, laws.size());
    std::vector<std::vector<double>> errors_of;
    std::string stays;
    double falls = 0, exact = 0, worst = 0;
    for (const Law& law : laws) {
        std::vector<double> errors;
        std::transform(steps.begin(), steps.end(), std::back_inserter(errors), law.error);
        const double most = *std::max_element(errors.begin(), errors.end()), order = order_of(steps, errors);
        const bool is_exact = most < exact_below, does_fall = !is_exact && order > 0.5;
        std::vector<Cell> row{law.name, law.quantity};
        for (const double error : errors)
            row.emplace_back(100 * error);
        row.emplace_back(is_exact ? Cell(std::string("-")) : Cell(order));
        row.emplace_back(std::string(is_exact ? "exact" : does_fall ? "yes" : "no"));
        table.add(row);
        falls += does_fall;
        exact += is_exact;
        worst = std::max(worst, errors.back());
        if (!is_exact && !does_fall)
            stays += (stays.empty() ? "" : "; ") + law.name + ", " + law.quantity;
        if (!is_exact) {
            curves.push_back(law.name + ": " + law.quantity);
            errors_of.push_back(std::move(errors));
        }
    }
    Table picture(curves);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        std::vector<Cell> row{steps[i]};
        for (const std::vector<double>& errors : errors_of)
            row.emplace_back(errors[i]);
        picture.add(row);
    }
    report.table("formulas", table);
    report.page_table("formulas", table, 2);
    report.table("formulas_curves", picture);
    report.plot("chapters/08_contact_by_distance/plots/formulas.gp");
    report.fact("formulas", "motions", static_cast<double>(laws.size()));
    report.fact("formulas", "fall", falls);
    report.fact("formulas", "exact", exact);
    report.fact("formulas", "stay", static_cast<double>(laws.size()) - falls - exact);
    report.fact("formulas", "which_stay", stays.empty() ? "none" : stays);
    report.fact("formulas", "worst_percent", 100 * worst, 2);
}

}  // namespace enduring::chapter08
