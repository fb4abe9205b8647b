#include "chapters/08_contact_by_distance/experiments/bouncing_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/sphere_impacts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace enduring::chapter08 {
namespace {

/// Rows of impacts, and how far the worst of them is off.
class Impacts {
public:
    double worst_percent = 0;

    void add(const std::string& test, double varied, const SphereImpact& impact)
    {
        const AfterImpact after = strike(impact);
        table_.add({test, varied, impact.dt, after.along.measured, after.along.formula, after.rim.measured,
                    after.rim.formula, 100 * after.largest_off, 100 * after.rebound});
        worst_percent = std::max(worst_percent, 100 * after.largest_off);
    }
    const Table& table() const { return table_; }

private:
    Table table_{{"test", "varied", "dt_s", "along_m_per_s", "by_formula_m_per_s", "rim_m_per_s",
                  "rim_by_formula_m_per_s", "off_percent", "rebound_percent"}};
};

/// Chung and Ooi's tests 1 to 3, along the normal: two balls and a ball on the ground, elastic, and with
/// other coefficients of restitution.
void rebounds(Report& report)
{
    Table table({"test", "restitution", "rebound_percent", "off_percent"});
    double worst = 0;
    const auto add = [&](const std::string& test, double restitution, double other_radius) {
        const double rebound = strike({.restitution = restitution, .other_radius = other_radius}).rebound;
        table.add({test, restitution, 100 * rebound, 100 * std::abs(rebound - restitution)});
        worst = std::max(worst, std::abs(rebound - restitution));
    };
    add("1: two equal balls", 1, sphere_radius);
    add("2: on the ground", 1, 0);
    for (const double restitution : {0.2, 0.4, 0.6, 0.8}) {
        add("3: two equal balls", restitution, sphere_radius);
        add("3: on the ground", restitution, 0);
    }
    report.table("spheres_rebound", table);
    report.page_table("spheres_rebound", table, 3);
    report.fact("spheres", "rebounds", static_cast<double>(table.rows().size()));
    report.fact("spheres", "worst_rebound_percent", 100 * worst, 2);
}

/// Chung and Ooi's tests 4 to 8.
void impacts(bool quick, Report& report)
{
    Impacts rows;
    for (const double dt : quick ? std::vector{5e-4} : std::vector{5e-4, 1e-4}) {
        for (int angle = 5; angle <= 85; angle += 10) {
            const double from_normal = angle * std::numbers::pi / 180, speed = 3.9;
            rows.add("4: angle [°]", angle,
                     {.normal_speed = speed * std::cos(from_normal),
                      .along = speed * std::sin(from_normal),
                      .dt = dt});
        }
        for (const double along : {0.5, 2.0, 8.0})
            rows.add("5: speed along [m/s]", along, {.normal_speed = 2, .along = along, .dt = dt});
        for (const double spin : {5.0, 15.0, 45.0}) {
            rows.add("6: spin [rad/s]", spin, {.spin = spin, .dt = dt});
            rows.add("7: spins of two equal balls [rad/s]", spin,
                     {.spin = spin, .other_radius = sphere_radius, .other_spin = spin, .dt = dt});
            rows.add("8: spin on a large ball [rad/s]", spin,
                     {.spin = spin, .other_radius = 2.5 * sphere_radius, .dt = dt});
        }
    }
    report.table("spheres", rows.table());
    report.page_table("spheres", rows.table(), 4);
    report.plot("chapters/08_contact_by_distance/plots/spheres.gp");
    report.fact("spheres", "impacts", static_cast<double>(rows.table().rows().size()));
    report.fact("spheres", "worst_percent", rows.worst_percent, 2);
}

/// The same with a rebound, for friction takes (1 + e) times as much.
void bounces(bool quick, Report& report)
{
    Table table({"test", "varied", "restitution", "dt_s", "along_m_per_s", "by_formula_m_per_s",
                 "rim_m_per_s", "rim_by_formula_m_per_s", "off_percent", "rebound_percent"});
    double worst = 0, worst_rebound = 0;
    const auto add = [&](const std::string& test, double varied, const SphereImpact& impact) {
        const AfterImpact after = strike(impact);
        table.add({test, varied, impact.restitution, impact.dt, after.along.measured, after.along.formula,
                   after.rim.measured, after.rim.formula, 100 * after.largest_off, 100 * after.rebound});
        worst = std::max(worst, 100 * after.largest_off);
        worst_rebound = std::max(worst_rebound, 100 * std::abs(after.rebound - impact.restitution));
    };
    for (const double dt : quick ? std::vector{5e-4} : std::vector{5e-4, 1e-4})
        for (const double e : {0.5, 1.0}) {
            for (const int angle : {5, 25, 45, 65, 85}) {
                const double from_normal = angle * std::numbers::pi / 180, speed = 3.9;
                add("4: angle [°]", angle,
                    {.normal_speed = speed * std::cos(from_normal),
                     .along = speed * std::sin(from_normal),
                     .restitution = e,
                     .dt = dt});
            }
            for (const double along : {0.5, 2.0, 8.0})
                add("5: speed along [m/s]", along,
                    {.normal_speed = 2, .along = along, .restitution = e, .dt = dt});
            for (const double spin : {5.0, 15.0, 45.0}) {
                add("6: spin [rad/s]", spin, {.spin = spin, .restitution = e, .dt = dt});
                add("7: spins of two equal balls [rad/s]", spin,
                    {.spin = spin,
                     .restitution = e,
                     .other_radius = sphere_radius,
                     .other_spin = spin,
                     .dt = dt});
                add("8: spin on a large ball [rad/s]", spin,
                    {.spin = spin, .restitution = e, .other_radius = 2.5 * sphere_radius, .dt = dt});
            }
        }
    report.table("spheres_bounce", table);
    report.page_table("spheres_bounce", table, 3);
    report.fact("spheres", "bounces", static_cast<double>(table.rows().size()));
    report.fact("spheres", "worst_bounce_percent", worst, 2);
    report.fact("spheres", "worst_bounce_rebound_percent", worst_rebound, 2);
}

/// SimBenchmark's cube of 6 by 6 by 6 balls, and a smaller one over the step.
void cubes_of_balls(bool quick, Report& report)
{
    struct Cube {
        int along_edge;
        double restitution, dt;
    };
    std::vector<Cube> cubes{{3, 0, 0.01}, {3, 1, 0.01}, {3, 1, 0.005}, {3, 1, 0.0025}};
    if (!quick)
        cubes.insert(cubes.end(), {{6, 0, 0.01}, {6, 1, 0.01}, {6, 1, 0.005}});
    Table table({"balls", "restitution", "dt_s", "deepest_um", "energy_left_percent", "most_gained_percent",
                 "sideways_percent"});
    double gained = 0, sideways = 0;
    for (const Cube& cube : cubes) {
        const BallsApart run = balls_apart(cube.along_edge, cube.restitution, cube.dt, 1);
        const int balls = cube.along_edge * cube.along_edge * cube.along_edge;
        table.add({static_cast<long>(balls), cube.restitution, cube.dt, 1e6 * run.deepest,
                   100 * run.energy.left, 100 * run.energy.most_gained, 100 * run.sideways});
        gained = std::max(gained, 100 * run.energy.most_gained);
        sideways = std::max(sideways, 100 * run.sideways);
    }
    report.table("spheres_666", table);
    report.page_table("spheres_666", table, 3);
    report.fact("spheres", "cubes_gained_percent", gained, 1);
    report.fact("spheres", "cubes_sideways_percent", sideways, 1);
}

/// What finer facets give: a ball on a vertex, one askew, and two balls.
void over_the_mesh(bool quick, Report& report)
{
    Table table({"subdivisions", "faces", "on_a_vertex_percent", "askew_percent", "two_balls_percent",
                 "rolling_after_slip_percent", "kept_when_rolling_percent"});
    const double dt = 1e-4;
    for (int subdivisions = 2; subdivisions <= (quick ? 3 : 5); ++subdivisions) {
        SphereImpact ball{.along = 0.5, .dt = dt, .subdivisions = subdivisions};
        const double on_vertex = strike(ball).largest_off;
        ball.askew = true;
        const double askew = strike(ball).largest_off;
        const double two =
            strike({.spin = 15, .other_radius = 2.5 * sphere_radius, .dt = dt, .subdivisions = subdivisions})
                .largest_off;
        const double rolling = slide_to_roll(0.002, subdivisions).speed.error(),
                     kept = 1 + keeps_rolling(0.002, subdivisions).error();
        table.add({static_cast<long>(subdivisions), 20L << (2 * subdivisions), 100 * on_vertex, 100 * askew,
                   100 * two, 100 * rolling, 100 * kept});
        report.fact("spheres", "finest_vertex_percent", 100 * on_vertex, 2);
        report.fact("spheres", "finest_askew_percent", 100 * askew, 2);
        report.fact("spheres", "finest_pair_percent", 100 * two, 2);
        report.fact("spheres", "finest_rolling_percent", 100 * rolling, 2);
        report.fact("spheres", "finest_kept_percent", 100 * kept, 3);
    }
    report.table("spheres_mesh", table);
    report.page_table("spheres_mesh", table, 3);
}

}  // namespace

/// Balls strike the ground and each other, slide and roll: against the formulas of round ones.
void spheres(const RunOptions& options, Report& report)
{
    rebounds(report);
    impacts(options.quick, report);
    bounces(options.quick, report);
    cubes_of_balls(options.quick, report);
    over_the_mesh(options.quick, report);
}

}  // namespace enduring::chapter08
