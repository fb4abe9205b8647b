#include "chapters/12_joints/experiments/experiments.hpp"
#include "chapters/12_joints/experiments/machine.hpp"
#include "common/geometry/box_shapes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter12 {
namespace {
namespace top_parts {

constexpr double wide = 0.2, thick = 0.05, arm = 0.15, mass = 1, gravity = 9.81, lean = 0.5;

/// Moments of inertia of a square plate: about its own axis, and about an axis across it through the tip [kg
/// m^2].
constexpr double about_axis = mass * wide * wide / 6,
                 about_tip = mass * (wide * wide + thick * thick) / 12 + mass * arm * arm;

/// The slow steady precession of a heavy top: the spin s about its own axis and the turning p about the
/// vertical obey p (C (s + p cos a) - A p cos a) = m g l.
double precession_of(double spin)
{
    const double a = (about_axis - about_tip) * std::cos(lean), b = about_axis * spin,
                 c = -mass * gravity * arm;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

struct Turning {
    double rate = 0;  ///< about the vertical [rad/s]
    double nods = 0;  ///< largest change of its lean [rad]
    double error = 0;
};

Turning turn(double spin, double dt, double duration)
{
    Machine machine(dt);
    const Eigen::AngleAxisd leaning(-lean, Vec3::UnitZ());
    const Vec3 axis = leaning * Vec3::UnitY();
    SurfaceMesh mesh = box(Vec3(wide, thick, wide));
    for (Vec3& vertex : mesh.vertices)
        vertex = leaning * Vec3(vertex + arm * Vec3::UnitY());
    const Vec3 omega = precession_of(spin) * Vec3::UnitY() + spin * axis;
    machine.scene.world.bodies.push_back(std::make_unique<RigidBody>(
        "top", mesh, with_mass(mass_properties(mesh, 1), mass), omega.cross(Vec3(arm * axis)), omega));
    machine.add_joint(JointKind::ball, 0, -1, Vec3::Zero());
    Turning of;
    double angle = 0, before = std::atan2(-axis.z(), axis.x());
    machine.run(duration, [&] {
        const Vec3 now = machine.scene.world.bodies[0]->centre().normalized();
        const double heading = std::atan2(-now.z(), now.x());
        angle += std::remainder(heading - before, 2 * std::numbers::pi);
        before = heading;
        of.nods = std::max(of.nods, std::abs(std::acos(now.y()) - lean));
    });
    of.rate = angle / machine.scene.world.time;
    of.error = machine.worst_error();
    return of;
}

}  // namespace top_parts
}  // namespace

/// Euler's and Lagrange's top on a ball joint: its steady precession against the formula.
void top(const RunOptions& options, Report& report)
{
    using namespace top_parts;
    const double duration = options.quick ? 1 : 10;
    Table table({"spin_rad_per_s", "dt_s", "exact_rad_per_s", "precession_rad_per_s", "off_percent",
                 "nods_deg", "joint_error_m"});
    double off = 0, nods = 0, error = 0;
    for (const double spin : {60.0, 100.0})
        for (const double dt : {0.002, 0.001}) {
            const Turning of = turn(spin, dt, duration);
            const double exact = precession_of(spin);
            table.add({spin, dt, exact, of.rate, 100 * (of.rate / exact - 1),
                       of.nods * 180 / std::numbers::pi, of.error});
            off = std::max(off, std::abs(of.rate / exact - 1));
            nods = std::max(nods, of.nods * 180 / std::numbers::pi);
            error = std::max(error, of.error);
        }
    report.table("top", table);
    report.page_table("top", table, 3);
    report.fact("top", "off_percent", 100 * off, 2);
    report.fact("top", "nods_deg", nods, 2);
    report.fact("top", "joint_error_m", error, 2);
}

}  // namespace enduring::chapter12
