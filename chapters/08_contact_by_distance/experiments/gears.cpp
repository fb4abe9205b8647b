#include "chapters/08_contact_by_distance/experiments/gears.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/polygon_gears.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/report/report.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace enduring::chapter08 {
namespace {

struct Polar {
    double radius, angle;
};

/// One flank from its foot to the tip; the angle is half the tooth at each radius.
/// An involute at the roll angle t has the radius base * sqrt(1 + t^2) and turns by t - atan t.
//! [involute]
std::vector<Polar> involute_flank(const GearShape& shape)
{
    const double pressure = shape.pressure_deg * std::numbers::pi / 180, pitch = shape.pitch_radius();
    const double base = pitch * std::cos(pressure), tip = pitch + shape.module;
    const double last = std::sqrt(tip * tip / (base * base) - 1);
    const double half_tooth = std::numbers::pi / (2 * shape.teeth) - 0.5 * shape.play / pitch +
                              std::tan(pressure) - pressure;
    std::vector<Polar> points{{pitch - 1.25 * shape.module, half_tooth}};
    for (int i = 0; i <= shape.flank_points; ++i) {
        const double t = last * i / shape.flank_points;
        points.push_back({base * std::sqrt(1 + t * t), half_tooth - (t - std::atan(t))});
    }
    return points;
}
//! [involute]

}  // namespace

SurfaceMesh gear(const GearShape& shape)
{
    if (shape.teeth < 17 || shape.teeth > 41)
        throw InputError("teeth of a gear: " + std::to_string(shape.teeth) + " is not in 17 to 41");
    if (shape.flank_points < 1)
        throw InputError("facets of a flank: " + std::to_string(shape.flank_points) + " is below 1");
    std::vector<Polar> outline;
    const std::vector<Polar> side = involute_flank(shape);
    for (int tooth = 0; tooth < shape.teeth; ++tooth) {
        const double middle = 2 * std::numbers::pi * tooth / shape.teeth;
        for (const auto& [r, half] : side)
            outline.push_back({r, middle - half});
        for (auto point = side.rbegin(); point != side.rend(); ++point)
            outline.push_back({point->radius, middle + point->angle});
    }
    SurfaceMesh mesh;
    const int n = static_cast<int>(outline.size());
    for (const double z : {-0.5 * shape.width, 0.5 * shape.width})
        for (const auto& [r, angle] : outline)
            mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    mesh.vertices.emplace_back(0, 0, -0.5 * shape.width);
    mesh.vertices.emplace_back(0, 0, 0.5 * shape.width);
    for (int i = 0; i < n; ++i) {
        const int next = (i + 1) % n;
        mesh.faces.insert(
            mesh.faces.end(),
            {{i, next, n + next}, {i, n + next, n + i}, {next, i, 2 * n}, {n + i, n + next, 2 * n + 1}});
    }
    return mesh;
}

namespace {

void add_gear(Scene& scene, const std::string& name, const GearShape& shape, const Vec3& centre, double angle,
              double torque)
{
    SurfaceMesh mesh = gear(shape);
    const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
    for (Vec3& vertex : mesh.vertices)
        vertex = centre + turn * vertex;
    auto body = std::make_unique<RigidBody>(name, mesh, mass_properties(mesh, 7800));
    body->hold({.translation = Vec3::Zero(), .rotation = Vec3::UnitZ()});
    body->add_load({.torque = TimedVector(Vec3(0, 0, torque))});
    scene.world.bodies.push_back(std::move(body));
}

Scene scene_of(const GearPair& pair)
{
    const GearShape first{.teeth = pair.teeth, .flank_points = pair.flank_points},
        second{.teeth = pair.other_teeth, .flank_points = pair.flank_points};
    Scene scene = chapter07::scene_of({}, pair.dt, 0, 0, 0);
    scene.world.planes.clear();
    scene.world.gravity = Vec3::Zero();
    add_gear(scene, "driven gear", first, Vec3::Zero(), 0, drive_torque);
    add_gear(scene, "other gear", second, Vec3(first.pitch_radius() + second.pitch_radius(), 0, 0),
             std::numbers::pi + std::numbers::pi / pair.other_teeth, brake_torque);
    return scene;
}

/// Follows an angle over whole turns.
class Turned {
public:
    explicit Turned(const Body& body) : motion_(dynamic_cast<const RigidBody&>(body).motion()), last_(angle())
    {}
    double follow()
    {
        const double now = angle();
        turned_ += std::remainder(now - last_, 2 * std::numbers::pi);
        last_ = now;
        return turned_;
    }
    double speed() const { return motion_.angular_velocity().z(); }
    double inertia() const { return 1 / motion_.inverse_inertia()(2, 2); }

private:
    double angle() const
    {
        const Vec3 x = motion_.pose().orientation * Vec3::UnitX(),
                   y = motion_.pose().orientation * Vec3::UnitY();
        return std::abs(x.z()) < std::abs(y.z()) ? std::atan2(x.y(), x.x()) : std::atan2(-y.x(), y.y());
    }
    const RigidMotion& motion_;
    double last_, turned_ = 0;
};

}  // namespace

GearRun turn_gears(const GearPair& pair, double turns)
{
    Scene scene = scene_of(pair);
    chapter07::SolveStatistics solves;
    const Solver solver = chapter07::counting_solver(chapter08_solver, solves)(scene.contact);
    Turned first(*scene.world.bodies[0]), second(*scene.world.bodies[1]);
    GearRun run;
    run.exact = static_cast<double>(pair.teeth) / pair.other_teeth;
    const double inertia = first.inertia() + second.inertia() * run.exact * run.exact;
    run.by_formula = (drive_torque - brake_torque * run.exact) / inertia;
    const double pitch = GearShape{.teeth = pair.teeth}.pitch_radius();

    Contacts contacts;
    double angle = 0, other = 0, start_speed = 0, start_time = -1, least = 1, most = -1;
    const auto steps =
        static_cast<long>(5 * std::sqrt(4 * std::numbers::pi * turns / run.by_formula) / pair.dt);
    for (long i = 0; i < steps && angle < 2 * std::numbers::pi * turns; ++i) {
        advance(scene.world, contacts, solver, pair.dt);
        angle = first.follow();
        other = second.follow();
        if (start_time < 0 && angle > 0.2) {  // long after the teeth have met
            start_time = scene.world.time;
            start_speed = first.speed();
            least = most = angle + other / run.exact;
        }
        if (start_time >= 0) {
            least = std::min(least, angle + other / run.exact);
            most = std::max(most, angle + other / run.exact);
        }
    }
    run.turns = angle / (2 * std::numbers::pi);
    run.ratio = -other / angle;
    run.apart_um = 1e6 * pitch * (most - least);
    run.acceleration = (first.speed() - start_speed) / (scene.world.time - start_time);
    run.lost = 1 - total_energy(scene.world).kinetic / (drive_torque * angle + brake_torque * other);
    run.unconverged = solves.unconverged;
    return run;
}

namespace {

void draw_gears(Report& report)
{
    Scene scene = scene_of({});
    Stage stage = stage_of(scene.world, scene);
    constexpr int width = 700, height = 420;
    stage.camera = frame(points_of(stage), {0.15, 0.35, 1}, static_cast<double>(width) / height);
    write_png(Renderer(width, height).draw(stage), report.file("gears.png"));
}

}  // namespace

/// A pair of gears that a torque turns: their ratio, and how fast they gain speed, over steps and facets.
void gears(const RunOptions& options, Report& report)
{
    Table table({"facets of a flank", "dt_s", "turns", "ratio_error", "apart_um", "acceleration",
                 "by_formula", "error_percent", "polygons_percent", "lost_percent", "unconverged"});
    double worst_ratio = 0;
    std::map<std::string, double> worst, polygons;
    const double turns = options.quick ? 0.3 : 10;
    std::vector<GearPair> pairs{{.flank_points = 4, .dt = 0.002}, {.flank_points = 8, .dt = 0.001}};
    if (!options.quick)
        pairs = {{.flank_points = 4, .dt = 0.002},
                 {.flank_points = 4, .dt = 0.001},
                 {.flank_points = 8, .dt = 0.002},
                 {.flank_points = 8, .dt = 0.001}};
    for (const GearPair& pair : pairs) {
        const GearRun run = turn_gears(pair, turns);
        const double error = 100 * (run.acceleration / run.by_formula - 1),
                     of_polygons = 100 * (acceleration_of_polygons(pair, turns) / run.by_formula - 1);
        table.add({static_cast<long>(pair.flank_points), pair.dt, run.turns, run.ratio / run.exact - 1,
                   run.apart_um, run.acceleration, run.by_formula, error, of_polygons, 100 * run.lost,
                   run.unconverged});
        worst_ratio = std::max(worst_ratio, std::abs(run.ratio / run.exact - 1));
        const std::string of = pair.flank_points < 8 ? "coarse" : "fine";
        worst[of] = std::max(worst[of], std::abs(error));
        polygons[of] = -of_polygons;
        report.fact("gears", "apart_um", run.apart_um, 2);  // of the last pair, the finest
    }
    report.table("gears", table);
    report.page_table("gears", table, 3);
    report.fact("gears", "turns", turns, 2);
    report.fact("gears", "ratio_error", worst_ratio, 1);
    for (const auto& [of, percent] : worst) {
        report.fact("gears", of + "_percent", percent, 2);
        report.fact("gears", of + "_polygons_percent", polygons[of], 2);
    }
    draw_gears(report);
}

}  // namespace enduring::chapter08
