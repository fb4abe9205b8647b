#include "chapters/04_friction/experiments/experiments.hpp"
#include "chapters/04_friction/experiments/launch.hpp"

#include <cmath>
#include <numbers>

namespace enduring::chapter04 {
namespace {

constexpr double pairs = 4, mass = 100, dt = 0.01, gravity = 9.81, angle_deg = 10;
constexpr double printed_spring = 100, printed_damper = 25;

/// One way to read k_fp and k_fd, as a stiffness [N/m] and a damper [N s/m] of one pair.
struct Reading {
    std::string words;
    double spring, damper;
};

//! [readings]
const std::vector<Reading> readings{
    {"of each pair, in SI units", printed_spring, printed_damper},
    {"of the whole body", printed_spring / pairs, printed_damper / pairs},
    {"per kilogram of the body", printed_spring* mass / pairs, printed_damper* mass / pairs},
    {"of an impulse: the factor Δt is missing", printed_spring / dt, printed_damper / dt},
    {"velocity as way per step", printed_spring, printed_damper* dt},
    {"both: impulse, and way per step", printed_spring / dt, printed_damper},
};
//! [readings]

YamaneNakamura friction_of(const Reading& reading, double mu_s)
{
    return {.mu_s = mu_s, .mu_d = 0.1, .spring = reading.spring, .damper = reading.damper};
}

/// Slid away or not: what swings about a place that it does not leave counts as held.
bool stays(const Reading& reading, double mu_s)
{
    Launch launch;
    launch.angle_deg = angle_deg;
    launch.friction = friction_of(reading, mu_s);
    double last = 0;
    follow(launch, 30, [&](const Progress1d& now) {
        last = now.way;
        return last > -10;
    });
    return last > -10;
}

double highest_way(const Reading& reading, double mu_s)
{
    Launch launch;
    launch.friction = friction_of(reading, mu_s);
    double highest = -1e9;
    follow(launch, 2, [&](const Progress1d& now) {
        highest = std::max(highest, now.way);
        return true;
    });
    return highest;
}

}  // namespace

/// Thesis 7.3: what k_fp = 100 and k_fd = 25 can mean, by what they do.
void printed_constants(const RunOptions&, Report& report)
{
    const double normal_force = mass * gravity * std::cos(angle_deg * std::numbers::pi / 180) / pairs;
    const double weight_along = mass * gravity * std::sin(angle_deg * std::numbers::pi / 180) / pairs;
    Table table({"reading", "k_FP [N/m]", "k_FD [N s/m]", "damping ratio", "sticks below [m/s]",
                 "hangs at [mm]", "highest [m]", "with 0.3", "with 0.4"});
    for (const Reading& reading : readings) {
        const double ratio = pairs * reading.damper / (2 * std::sqrt(pairs * reading.spring * mass));
        table.add({reading.words, reading.spring, reading.damper, ratio, 0.3 * normal_force / reading.damper,
                   1000 * weight_along / reading.spring, highest_way(reading, 0.3),
                   stays(reading, 0.3) ? "holds" : "slides", stays(reading, 0.4) ? "holds" : "slides"});
    }
    report.table("printed_constants", table);
    report.page_table("printed_constants", table, 3);
    report.fact("printed_constants", "sticks_below", 0.3 * normal_force / printed_damper, 3);
    report.fact("printed_constants", "hangs_at_m", weight_along / printed_spring, 2);
    const double up = 9.81 * (std::sin(angle_deg * std::numbers::pi / 180) +
                              0.1 * std::cos(angle_deg * std::numbers::pi / 180));
    report.fact("printed_constants", "coulomb_highest", 9 / (2 * up), 3);
}

}  // namespace enduring::chapter04
