#include "chapters/04_friction/experiments/tilting.hpp"

#include "chapters/04_friction/experiments/experiments.hpp"
#include "chapters/04_friction/experiments/launch.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/solver.hpp"
#include "common/simulation/step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter04 {
namespace {

constexpr double degrees_per_second = 0.2, slides = 0.01;  // [deg/s], [m/s]

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace

double sliding_angle(double height, double dt, const FrictionParameters& friction)
{
    Launch level{0, dt, height, 0, friction};
    Scene scene = scene_of(level);
    const Solver solver = chapter04_solver(scene.contact);
    Contacts contacts;
    double angle = 0;
    while (angle < 60) {
        angle = degrees_per_second * scene.world.time;
        scene.world.gravity = 9.81 * Vec3(-std::sin(radians(angle)), -std::cos(radians(angle)), 0);
        advance(scene.world, contacts, solver, dt);
        if (std::abs(along_slope(scene.world, 0).speed) > slides)
            break;
    }
    return angle;
}

/// A ramp that tilts slowly, until its load slides: what mu_s is for. Gravity tilts in the ramp's place.
void tilting(const RunOptions& options, Report& report)
{
    Table table({"body", "coulomb_deg", "dt_s", "angle_deg", "ratio"});
    double worst = 0;
    for (const double height : {0.1, 1.0})
        for (const double coulomb : options.quick ? std::vector{10.0} : std::vector{5.0, 10.0, 20.0, 30.0})
            for (const double dt : options.quick ? std::vector{0.01} : std::vector{0.01, 0.002}) {
                const double mu_s = std::tan(radians(coulomb));
                const double angle = sliding_angle(height, dt,
                                                   with_mu_s(MassSplitting{.spring = 20000}, mu_s));
                const double ratio = mu_s / std::tan(radians(angle));
                table.add({height < 1 ? "block" : "cube", coulomb, dt, angle, ratio});
                worst = std::max(worst, std::abs(ratio - 1));
            }
    report.table("tilting", table);
    report.page_table("tilting", table, 4);
    report.fact("tilting", "worst_percent", 100 * worst, 2);
}

}  // namespace enduring::chapter04
