#include "chapters/08_contact_by_distance/experiments/euler_disk.hpp"

#include "chapters/06_redefinition/experiments/rolling.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/formula_runs.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/report.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

constexpr double disk_radius = 0.1, disk_mass = 0.4;  // [m], [kg]

/// About y; the middles of its lower and its upper face are its last two vertices.
SurfaceMesh flat_prism(int sides, double thickness)
{
    SurfaceMesh mesh = chapter06::prism(sides, disk_radius, 0.5 * thickness);
    for (Vec3& vertex : mesh.vertices)
        vertex = Vec3(vertex.x(), vertex.z(), -vertex.y());
    return mesh;
}

Vec3 disk_axis(const Body& body)
{
    const auto points = body.positions_t0();
    return (points[points.size() - 1] - points[points.size() - 2]).normalized();
}

double disk_lean(const Vec3& axis) { return std::acos(std::clamp(axis.y(), -1.0, 1.0)); }

}  // namespace

//! [disk_rate]
double disk_rate(double radius, double half_thickness, double across_per_kg, double along_per_kg, double lean)
{
    const double sine = std::sin(lean), cosine = std::cos(lean);
    return std::sqrt(formula_runs::earth * (radius * cosine - half_thickness * sine) /
                     (sine * (across_per_kg * cosine - along_per_kg * sine * half_thickness / radius)));
}
//! [disk_rate]

DiskRun spin_disk(const EulerDisk& disk, double duration)
{
    const double half = 0.5 * disk.thickness, lean = disk.lean_deg * formula_runs::degree;
    const double across = disk_radius * disk_radius / 4 + disk.thickness * disk.thickness / 12,
                 along = disk_radius * disk_radius / 2;
    SurfaceMesh mesh = flat_prism(disk.sides, disk.thickness);
    const Quaternion turn(
        Eigen::AngleAxisd(-lean, Vec3::UnitZ()));  // the first corner of the lower face is down, towards x
    for (Vec3& vertex : mesh.vertices)
        vertex = turn * vertex;
    const Vec3 to_rim = mesh.vertices.front(), axis = turn * Vec3::UnitY();
    for (Vec3& vertex : mesh.vertices)
        vertex.y() -= to_rim.y();
    // The centre and the place on the rim rest: it turns about the line through both, as fast as its axis
    // goes round.
    const double rate = disk_rate(disk_radius, half, across, along, lean);
    const Vec3 angular_velocity = -rate * std::sin(lean) / disk_radius * to_rim;

    Scene scene = chapter07::scene_of({}, disk.dt, 0, disk.mu, disk.mu);
    scene.world.bodies.push_back(std::make_unique<RigidBody>(
        "disk", mesh, with_mass(mass_properties(mesh, 1000), disk_mass), Vec3::Zero(), angular_velocity));
    const Solver solver = chapter08_solver(scene.contact);
    const Body& body = *scene.world.bodies[0];
    const double energy = total_energy(scene.world).total();
    const Vec3 centre = body.centre();

    DiskRun found;
    Contacts contacts;
    double turned = 0;
    const long steps = std::lround(duration / disk.dt);
    for (long i = 0; i < steps; ++i) {
        const Vec3 before = disk_axis(body);
        advance(scene.world, contacts, solver, disk.dt);
        const Vec3 after = disk_axis(body);
        turned += formula_runs::turn_about_y(before, after);
        found.by_formula += disk_rate(disk_radius, half, across, along, disk_lean(after)) /
                            static_cast<double>(steps);
    }
    found.rate = turned / (static_cast<double>(steps) * disk.dt);
    found.lean_change_deg = (disk_lean(disk_axis(body)) - disk_lean(axis)) / formula_runs::degree;
    found.energy_change = (total_energy(scene.world).total() - energy) / energy;
    found.centre_moved_mm = 1000 * std::hypot(body.centre().x() - centre.x(), body.centre().z() - centre.z());
    return found;
}

/// Euler's disk over its facets and the step, with friction and without.
void disk(const RunOptions& options, Report& report)
{
    Table table({"sides", "dt_s", "mu", "rate", "by_formula", "error_percent", "lean_change_deg",
                 "energy_change", "centre_moved_mm"});
    double worst = 0, finest = 0, gained = 0;
    const std::vector<int> sides = options.quick ? std::vector{24, 96} : std::vector{24, 48, 96, 192, 384};
    for (const double mu : {0.0, 1.0})
        for (const int n : sides)
            for (const double dt :
                 options.quick ? std::vector{0.001} : std::vector{0.002, 0.001, 0.0005, 0.00025}) {
                const DiskRun run = spin_disk({.sides = n, .mu = mu, .dt = dt}, 0.3);
                const double error = 100 * (run.rate / run.by_formula - 1);
                table.add({static_cast<long>(n), dt, mu, run.rate, run.by_formula, error, run.lean_change_deg,
                           run.energy_change, run.centre_moved_mm});
                worst = std::max(worst, std::abs(error));
                gained = std::max(gained, run.energy_change);
                if (n == sides.back())
                    finest = std::abs(error);
            }
    report.table("disk", table);
    report.page_table("disk", table, 3);
    report.fact("disk", "worst_percent", worst, 2);
    report.fact("disk", "finest_percent", finest, 2);
    report.fact("disk", "gained", gained, 1);
}

}  // namespace enduring::chapter08
