#include "chapters/08_contact_by_distance/experiments/driven_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/freed_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/hinged_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace enduring::chapter08 {
namespace {

/// The largest slope on which the block of materials stays, in steps of a hundredth [degrees].
double holding_angle(double dt)
{
    double holds = 20, slides = 35;
    while (slides - holds > 0.01) {
        const double middle = 0.5 * (holds + slides);
        (materials_hold(middle, dt) ? holds : slides) = middle;
    }
    return holds;
}

struct Case {
    std::string name, fact, what;
    std::function<AgainstFormula(double dt)> run;
};

std::vector<Case> all_cases()
{
    return {
        {"piston, its table", "piston", "height [m]", piston},
        {"turntable, its table", "turntable", "speed where it slides [rad/s]", turntable_slip},
        {"conveyor", "conveyor_slid", "slid [m]", [](double dt) { return conveyor(dt).slid; }},
        {"conveyor", "conveyor_heat", "heat [J]", [](double dt) { return conveyor(dt).heat; }},
        {"puck, a force", "puck", "distance [m]", pushed_puck},
        {"wheel, locked, a torque", "wheel", "speed [rad/s]", torque_on_wheel},
        {"slider, locked, hit", "slider", "momentum [N s]", hit_slider},
        {"bar on a hinge, swings", "swing", "period [s]", swinging_bar},
        {"door on a hinge, hit", "door_speed", "speed [rad/s]", [](double dt) { return hit_door(dt).speed; }},
        {"door on a hinge, hit", "door_momentum", "momentum about the hinge [N m s]",
         [](double dt) { return hit_door(dt).momentum; }},
        {"crank and slider", "crank", "where the slider is [m]", slider_crank},
        {"pin in the slot of a yoke", "slot", "where the yoke is [m]", pin_in_slot},
        {"puck on a spring, rubs", "spring", "first turning point [m]", puck_on_spring},
        {"soft bar, two forces", "two_forces", "angle [rad]", turned_by_two_forces},
        {"soft bar, turned by 360 degrees, let go", "let_go", "period [s]",
         [](double dt) { return twisted_and_let_go(dt).period; }},
        {"rigid sheet between box and ball", "sheet", "height of the ball [m]", sheet_on_box},
        {"two materials", "materials_slide", "acceleration [m/s^2]",
         [](double dt) { return slide_of_materials(30, dt); }},
        {"two materials", "materials_hold", "angle where it holds [degrees]",
         [](double dt) {
             return AgainstFormula{holding_angle(dt), std::atan(0.5) * 180 / std::numbers::pi};
         }},
    };
}

/// Why the door's speed misses its formula: by the step, and by the springs' stiffness.
void tell_door(const RunOptions& options, Report& report)
{
    constexpr double stiffest = 25600, shortest = 0.000625;
    const auto error = [](double dt, double stiffness) {
        return 100 * hit_door(dt, stiffness).speed.error();
    };
    Table table({"k_dt2_over_m", "dt_s", "error_percent"});
    for (const double stiffness : {400.0, 1600.0, stiffest})
        for (const double dt :
             options.quick ? std::vector{0.01, shortest} : std::vector{0.01, 0.005, 0.0025, shortest})
            table.add({stiffness, dt, error(dt, stiffness)});
    report.table("driven_door", table);
    report.fact("driven", "door_spring_percent", error(shortest, 400), 2);
    report.fact("driven", "door_stiffer_spring_percent", error(shortest, 1600), 2);
    const double longest = error(0.01, stiffest);
    report.fact("driven", "door_stiff_percent", longest, 2);
    report.fact("driven", "door_order", std::log2(longest / error(0.005, stiffest)), 2);
}

/// Why the bar that is let go misses its formula: by how far it is turned, and by its elements.
void tell_let_go(const RunOptions& options, Report& report)
{
    Table table({"turn_deg", "elements", "cells", "dt_s", "period_s", "formula_s", "error_percent"});
    const auto add = [&](const TwistedBar& bar, const std::string& fact) {
        double worst = 0;
        for (const double dt : options.quick ? std::vector{0.01} : std::vector{0.01, 0.005}) {
            const AgainstFormula result = twisted_and_let_go(dt, bar).period;
            const std::string across = std::to_string(bar.across);
            table.add({bar.turn_deg, bar.basis, std::to_string(bar.along) + " x " + across + " x " + across,
                       dt, result.measured, result.formula, 100 * result.error()});
            worst = std::max(worst, std::abs(100 * result.error()));
        }
        report.fact("driven", fact, worst, 2);
    };
    add({180}, "let_go_180_percent");
    add({10}, "let_go_10_percent");
    add({10, 8, 2}, "let_go_2_cells_percent");
    add({10, 8, 3}, "let_go_3_cells_percent");
    add({10, 8, 4}, "let_go_4_cells_percent");
    add({10, 8, 4, "linear"}, "let_go_linear_percent");
    report.table("let_go", table);
    report.page_table("let_go", table, 3);
}

}  // namespace

/// What a scene can say of a body beside its start, each against a formula: given motion, running surfaces,
/// forces, locked directions, materials.
void driven(const RunOptions& options, Report& report)
{
    Table table({"scene", "quantity", "dt_s", "measured", "formula", "error_percent"});
    for (const Case& one : all_cases()) {
        double worst = 0;
        for (const double dt : options.quick ? std::vector{0.01} : std::vector{0.01, 0.005, 0.0025}) {
            const AgainstFormula result = one.run(dt);
            table.add({one.name, one.what, dt, result.measured, result.formula, 100 * result.error()});
            worst = std::max(worst, std::abs(100 * result.error()));
        }
        report.fact("driven", one.fact + "_percent", worst, 2);
    }
    report.table("driven", table);
    report.page_table("driven", table, 4);
    tell_door(options, report);
    tell_let_go(options, report);
}

}  // namespace enduring::chapter08
