#include "chapters/06_redefinition/experiments/mesh_slope.hpp"

#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/run.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter06 {
namespace {

// [m], between block and triangles: a pair begins with a crossing, so it starts outside
constexpr double gap = 0.0005;
constexpr double half_height = 0.05, gravity = 9.81;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

nlohmann::json list(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Vec3 uphill(double angle_deg) { return {std::cos(radians(angle_deg)), std::sin(radians(angle_deg)), 0}; }

Vec3 middle(const World& world) { return body_named(world, "block").centre(); }

/// Time to come up and stop [s].
double rise_time(const SlopeTrial& trial)
{
    const double angle = radians(trial.angle_deg);
    return trial.speed / (gravity * (std::sin(angle) + trial.mu_d * std::cos(angle)));
}

}  // namespace

Scene scene_of(const SlopeTrial& trial)
{
    const Vec3 up = uphill(trial.angle_deg), out(-up.y(), up.x(), 0);
    const Vec3 position = trial.start * up + (half_height + gap) * out + Vec3(0, 0, 0.13);
    const nlohmann::json change{
        {"dt", trial.dt},
        {"contact",
         {{"stiffness", 200 / trial.dt}, {"friction", {{"mu_s", trial.mu_s}, {"mu_d", trial.mu_d}}}}},
        {"/bodies/slope/shape/slope/angle_deg", trial.angle_deg},
        {"/bodies/block/rotation/angle_deg", trial.angle_deg},
        {"/bodies/block/position", list(position)},
        {"/bodies/block/velocity", list(trial.speed * up)}};
    return load_scene(scene_file("block_on_triangles"), change.dump());
}

//! [holds]
bool holds(const SlopeTrial& trial)
{
    Scene scene = scene_of(trial);
    scene.duration = rise_time(trial) + 6;
    double from = 0, to = 0;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        to = middle(world).dot(uphill(trial.angle_deg));
        if (world.time <= scene.duration - 5)
            from = to;
    });
    RunLimits limits;
    limits.stop = [&](const World& world, const Contacts&) {
        return world.time > scene.duration - 5 && std::abs(to - from) > 0.001;
    };
    run(scene, chapter06_solver(scene.contact), {&watch}, limits);
    return std::abs(to - from) < 0.001;
}
//! [holds]

double threshold_over_tangent(double angle_deg, double dt)
{
    double slides = 0.9, held = 1.1;
    for (int i = 0; i < 5; ++i) {
        const double ratio = 0.5 * (slides + held), mu_s = ratio * std::tan(radians(angle_deg));
        (holds({angle_deg, dt, mu_s, std::min(0.1, mu_s / 2)}) ? held : slides) = ratio;
    }
    return held;
}

double slide_acceleration(double angle_deg, double dt, double mu_d)
{
    Scene scene = scene_of({angle_deg, dt, mu_d, mu_d, -1, 4});
    scene.duration = 1.4;
    double before = 0, after = 0;
    const double from = 0.6;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        const Body& block = body_named(world, "block");
        after = -block.linear_momentum().dot(uphill(angle_deg)) / block.mass();
        if (world.time < from + 0.5 * dt)
            before = after;
    });
    run(scene, chapter06_solver(scene.contact), {&watch});
    return (after - before) / (scene.duration - from);
}

/// Chapter 4's criteria on triangles.
void mesh_slope(const RunOptions& options, Report& report)
{
    artefact("mesh_slope", options, report);
    Table table({"angle_deg", "dt_s", "mu_static", "mu_static_over_tan", "acceleration_over_exact"});
    double worst_threshold = 0, worst_fine = 0, worst_acceleration = 0;  // the second at dt = 0.002 s
    for (const double angle : {5.0, 10.0, 20.0, 30.0})
        for (const double dt : {0.01, 0.002}) {
            if (options.quick && (dt < 0.01 || angle != 10))
                continue;
            const double tangent = std::tan(radians(angle)), mu_d = tangent / 2,
                         ratio = threshold_over_tangent(angle, dt);
            const double exact = gravity * (std::sin(radians(angle)) - mu_d * std::cos(radians(angle)));
            const double acceleration = slide_acceleration(angle, dt, mu_d) / exact;
            table.add({angle, dt, ratio * tangent, ratio, acceleration});
            double& worst_here = dt == 0.01 ? worst_threshold : worst_fine;
            worst_here = std::max(worst_here, std::abs(ratio - 1));
            worst_acceleration = std::max(worst_acceleration, std::abs(acceleration - 1));
        }
    report.table("mesh_slope_threshold", table);
    report.page_table("mesh_slope_threshold", table, 4);
    report.fact("mesh_slope", "worst_threshold_percent", 100 * worst_threshold, 2);
    report.fact("mesh_slope", "worst_threshold_fine_percent", 100 * worst_fine, 2);
    report.fact("mesh_slope", "worst_acceleration_percent", 100 * worst_acceleration, 2);
}

}  // namespace enduring::chapter06
