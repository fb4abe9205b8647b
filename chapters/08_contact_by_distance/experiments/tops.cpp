#include "chapters/08_contact_by_distance/experiments/tops.hpp"

#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/formula_runs.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

constexpr double mass = 0.5, radius = 0.08, widest_at = 0.06, height = 0.09;  // [kg], [m]
constexpr double degree = std::numbers::pi / 180;

/// Vertex 0 is the lower tip, at the origin; the axis is y.
SurfaceMesh double_cone(int sides)
{
    SurfaceMesh mesh;
    mesh.vertices = {Vec3::Zero(), Vec3(0, height, 0)};
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        mesh.vertices.emplace_back(radius * std::cos(angle), widest_at, radius * std::sin(angle));
        const int one = 2 + i, next = 2 + (i + 1) % sides;
        mesh.faces.push_back({0, one, next});
        mesh.faces.push_back({1, next, one});
    }
    return mesh;
}

/// Where the tip of the axis is, seen from the foot.
Vec3 axis_of(const Body& body) { return (body.positions_t0()[1] - body.positions_t0()[0]).normalized(); }

double lean_of(const Vec3& axis) { return std::acos(std::clamp(axis.y(), -1.0, 1.0)); }

}  // namespace

double steady_precession(double across, double along, double moment, double spin, double lean)
{
    const double a = across * std::cos(lean), b = along * spin;
    const double root = b * b - 4 * a * moment;
    if (!(root >= 0))
        throw InputError("spin: a top that turns at " + std::to_string(spin) +
                         " rad/s has no steady precession");
    return 2 * moment / (b + std::sqrt(root));
}

Precession spin_top(const Top& top, double duration)
{
    const double lean = top.lean_deg * degree;
    SurfaceMesh mesh = double_cone(top.sides);
    const MassProperties upright = with_mass(mass_properties(mesh, 1000), mass);
    const double arm = upright.centre.y();
    const double across = upright.inertia(0, 0) + mass * arm * arm, along = upright.inertia(1, 1);

    Precession found;
    found.by_formula = steady_precession(across, along, mass * 9.81 * arm, top.spin, lean);
    const Eigen::AngleAxisd turn(-lean, Vec3::UnitZ());  // towards x
    for (Vec3& vertex : mesh.vertices)
        vertex = turn * vertex;
    const Vec3 axis = turn * Vec3::UnitY();
    const Vec3 angular_velocity = found.by_formula * Vec3::UnitY() +
                                  (top.spin - found.by_formula * std::cos(lean)) * axis;
    const MassProperties properties = with_mass(mass_properties(mesh, 1000), mass);

    Scene scene = chapter07::scene_of({}, top.dt, 0, 1, 1);
    scene.world.bodies.push_back(std::make_unique<RigidBody>(
        "top", mesh, properties, angular_velocity.cross(properties.centre), angular_velocity));
    const Solver solver = chapter07::counting_solver(chapter08_solver, found.solves)(scene.contact);
    const Body& body = *scene.world.bodies[0];
    const double kinetic = total_energy(scene.world).kinetic, energy = total_energy(scene.world).total();

    Contacts contacts;
    double turned = 0;
    const long steps = std::lround(duration / top.dt);
    for (long i = 0; i < steps; ++i) {
        const Vec3 before = axis_of(body);
        advance(scene.world, contacts, solver, top.dt);
        const Vec3 after = axis_of(body);
        turned += formula_runs::turn_about_y(before, after);
    }
    found.rate = turned / (static_cast<double>(steps) * top.dt);
    found.lean_change_deg = (lean_of(axis_of(body)) - lean) / degree;
    found.energy_change = (total_energy(scene.world).total() - energy) / kinetic;
    found.tip_moved_mm = 1000 * body.positions_t0()[0].norm();
    return found;
}

/// Tops on their tips, over spin, lean and step.
void tops(const RunOptions& options, Report& report)
{
    GrowingTable table(report, "tops",
                       {"spin_rad_s", "lean_deg", "dt_s", "rate", "by_formula", "error_percent",
                        "lean_change_deg", "energy_change", "tip_moved_mm", "unconverged", "solves"},
                       3 * 2 * 3);
    double worst = 0, finest = 0, leaned = 0, gained = 0;
    for (const double spin : {50.0, 100.0, 200.0})
        for (const double lean : {10.0, 30.0})
            for (const double dt : {0.005, 0.002, 0.0005}) {
                if (options.quick && (dt < 0.002 || lean > 10))
                    continue;
                const Precession found = spin_top({spin, lean, dt}, 2);
                const double error = 100 * (found.rate / found.by_formula - 1);
                table.add({spin, lean, dt, found.rate, found.by_formula, error, found.lean_change_deg,
                           found.energy_change, found.tip_moved_mm, found.solves.unconverged,
                           found.solves.solves});
                worst = std::max(worst, std::abs(error));
                leaned = std::max(leaned, std::abs(found.lean_change_deg));
                gained = std::max(gained, found.energy_change);
                if (dt < 0.001)
                    finest = std::max(finest, std::abs(error));
            }
    report.table("tops", table);
    report.page_table("tops", table, 3);
    report.fact("tops", "worst_percent", worst, 2);
    report.fact("tops", "finest_percent", finest, 2);
    report.fact("tops", "leaned_deg", leaned, 2);
    report.fact("tops", "gained", gained, 1);
}

}  // namespace enduring::chapter08
