#include "chapters/08_contact_by_distance/experiments/launch.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

constexpr double mass = 100;  // [kg], as chapter 4's

double tangent(double slope_deg) { return std::tan(slope_deg * std::numbers::pi / 180); }

/// Chapter 4's cube of 1 m, launched uphill.
Scene launched(const Launch& launch)
{
    Scene scene = chapter07::scene_of({}, launch.dt, launch.slope_deg, launch.mu_s, launch.mu_d);
    SurfaceMesh cube = box(Vec3::Ones());
    for (Vec3& x : cube.vertices)
        x.y() += 0.5;
    scene.world.bodies.push_back(std::make_unique<RigidBody>(
        "cube", cube, with_mass(mass_properties(cube, 1000), mass), Vec3(launch.speed, 0, 0)));
    return scene;
}

}  // namespace

bool stays(const Launch& launch)
{
    Scene scene = launched(launch);
    chapter07::SolveStatistics solves;
    const Solver solver = chapter07::counting_solver(chapter08_solver, solves)(scene.contact);
    Contacts contacts;
    const auto place = [&] { return scene.world.bodies[0]->centre().x(); };
    const auto until = [&](double time) {
        while (scene.world.time < time)
            advance(scene.world, contacts, solver, launch.dt);
        return place();
    };
    const double a = launch.slope_deg * std::numbers::pi / 180,
                 turns = launch.speed / (9.81 * (std::sin(a) + launch.mu_d * std::cos(a)));
    const double before = until(turns + 0.5);
    return std::abs(until(turns + 2.5) - before) < 1e-3;
}

//! [weak_corners]
double weak_corners(double slope_deg, double falls)
{
    const double t = tangent(slope_deg);
    return std::min(1 / (1 - t), 2 / ((1 + t) + falls * (1 - t)));
}
//! [weak_corners]

namespace {

//! [rocking]
/// Damping ratio of the cube as it rocks on its corners, four springs of h = 100: backward Euler turns and
/// shrinks a swing by 1 / (1 +- i sqrt(h)).
double rocking_damping()
{
    const double corners = 4, lever = 0.5, inertia = 1.0 / 6;  // of a kilogram
    const double corner_mass = 0.25;                           // 1 / (1 + (lever^2 + lever^2) / inertia)
    const double h = 100 * corner_mass * corners * lever * lever / inertia;
    return 0.5 * std::log(1 + h) / std::atan(std::sqrt(h));
}
//! [rocking]

struct Scan {
    double first_that_stays = 9, last_that_slides = 0;  ///< over tan
};

/// @param from, to  coefficient over tan
/// @param falls     mu_d over mu_s
Scan scan(Launch launch, double from, double to, int count, double falls)
{
    Scan found;
    for (int i = 0; i < count; ++i) {
        const double part = from + (to - from) * i / (count - 1);
        launch.mu_s = part * tangent(launch.slope_deg);
        launch.mu_d = falls * launch.mu_s;
        if (stays(launch))
            found.first_that_stays = std::min(found.first_that_stays, part);
        else
            found.last_that_slides = std::max(found.last_that_slides, part);
    }
    return found;
}

/// With one coefficient for what holds and what slips.
void with_one_coefficient(bool quick, Report& report)
{
    GrowingTable table(report, "launch",
                       {"slope_deg", "dt_s", "first_that_stays", "last_that_slides", "by_rocking"},
                       quick ? 2 : 4 * 2);
    double worst = 0;
    for (const double slope : quick ? std::vector{10.0} : std::vector{5.0, 10.0, 20.0, 30.0})
        for (const double dt : {0.01, 0.002}) {
            const Scan found = scan({slope, dt, 0, 0}, 0.95, 1.05, quick ? 11 : 41, 1);
            table.add({slope, dt, found.first_that_stays, found.last_that_slides,
                       1 + 0.6 * 2 * std::exp(-std::numbers::pi * rocking_damping())});
            worst =
                std::max({worst, std::abs(found.first_that_stays - 1), std::abs(found.last_that_slides - 1)});
        }
    report.table("launch", table);
    report.page_table("launch", table, 4);
    report.fact("launch", "damping", rocking_damping(), 2);
    report.fact("launch", "worst_percent", 100 * worst, 2);
}

/// With a coefficient that falls, laid down at rest.
void laid(bool quick, Report& report)
{
    constexpr double falls = 0.8;
    GrowingTable table(report, "launch_laid",
                       {"slope_deg", "dt_s", "first_that_stays", "last_that_slides", "if_what_slipped_slips"},
                       quick ? 2 : 4 * 2);
    double worst = 0;
    for (const double slope : quick ? std::vector{10.0} : std::vector{5.0, 10.0, 20.0, 30.0})
        for (const double dt : {0.01, 0.002}) {
            const Scan found = scan({slope, dt, 0, 0, 0}, 0.95, 1.25, quick ? 16 : 61, falls);
            table.add(
                {slope, dt, found.first_that_stays, found.last_that_slides, weak_corners(slope, falls)});
            worst =
                std::max({worst, std::abs(found.first_that_stays - 1), std::abs(found.last_that_slides - 1)});
        }
    report.table("launch_laid", table);
    report.page_table("launch_laid", table, 4);
    report.fact("launch", "laid_worst_percent", 100 * worst, 2);
}

/// With a coefficient that falls: of many launch speeds, how many stay.
void with_two_coefficients(bool quick, Report& report)
{
    Table table({"slope_deg", "dt_s", "mu_s_over_tan", "mu_d_over_tan", "launches", "stay_percent",
                 "if_what_slipped_slips_percent"});
    double fewest = 100, fewest_by_chance = 100;
    const long launches = quick ? 20 : 100;
    for (const double slope : {10.0, 20.0})
        for (const double dt : quick ? std::vector{0.01} : std::vector{0.01, 0.002})
            for (const double part_s : {1.1, 2.5})
                for (const double part_d : {0.2, 0.9}) {
                    long stay = 0;
                    for (long i = 0; i < launches; ++i)
                        stay += stays({slope, dt, part_s * tangent(slope), part_d * tangent(slope),
                                       2 + static_cast<double>(i) / static_cast<double>(launches)});
                    const double measured = 100.0 * static_cast<double>(stay) / static_cast<double>(launches),
                                 chance = part_s < weak_corners(slope, part_d / part_s)
                                              ? 0
                                              : 100 * 2 * part_d / (1 + part_d);
                    table.add({slope, dt, part_s, part_d, launches, measured, chance});
                    fewest = std::min(fewest, measured);
                    fewest_by_chance = std::min(fewest_by_chance, chance);
                }
    report.table("launch_chance", table);
    report.page_table("launch_chance", table, 3);
    report.fact("launch", "fewest_percent", fewest, 3);
    report.fact("launch", "fewest_by_chance_percent", fewest_by_chance, 2);
}

}  // namespace

/// A cube is launched up a slope: does it stay where it turns round?
void launch(const RunOptions& options, Report& report)
{
    with_one_coefficient(options.quick, report);
    laid(options.quick, report);
    with_two_coefficients(options.quick, report);
}

}  // namespace enduring::chapter08
