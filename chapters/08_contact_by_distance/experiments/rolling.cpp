#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

struct Rolled {
    double acceleration, exact;  ///< of the centre, down the slope [m/s^2]
};

/// A ball of 0.2 m and 20 kg rolls down; its acceleration from 0.6 s to 1.5 s.
Rolled roll(double slope_deg, double dt, int subdivisions)
{
    constexpr double radius = 0.2, mass = 20, from_s = 0.6, to_s = 1.5;
    Scene scene = chapter07::scene_of({}, dt, slope_deg);
    SurfaceMesh mesh = sphere(radius, subdivisions);
    double lowest = 0;
    for (const Vec3& x : mesh.vertices)
        lowest = std::min(lowest, x.y());
    for (Vec3& x : mesh.vertices)
        x.y() -= lowest;
    const MassProperties properties = with_mass(mass_properties(mesh, 1000), mass);
    scene.world.bodies.push_back(std::make_unique<RigidBody>("ball", mesh, properties));
    const Solver solver = chapter08_solver(scene.contact);
    Contacts contacts;
    double first = 0;
    const long from = std::lround(from_s / dt), to = std::lround(to_s / dt);
    for (long i = 0; i < to; ++i) {
        if (i == from)
            first = scene.world.bodies[0]->mean_velocity().x();
        advance(scene.world, contacts, solver, dt);
    }
    const double change = scene.world.bodies[0]->mean_velocity().x() - first;
    const double down = 9.81 * std::sin(slope_deg * std::numbers::pi / 180), mr2 = mass * radius * radius;
    return {-change / (static_cast<double>(to - from) * dt), down * mr2 / (mr2 + properties.inertia(2, 2))};
}

}  // namespace

/// A ball on a slope, over slopes, steps and meshes.
void rolling(const RunOptions& options, Report& report)
{
    Table table({"slope_deg", "dt_s", "ball_faces", "acceleration", "exact", "error_percent"});
    double worst = 0;
    for (const double slope : {5.0, 15.0, 25.0})
        for (const double dt : {0.01, 0.0025})
            for (const int subdivisions : {3, 4}) {
                if (options.quick && dt < 0.01)
                    continue;
                const auto [measured, exact] = roll(slope, dt, subdivisions);
                const double error = 100 * (measured / exact - 1);
                table.add({slope, dt, 20L << (2 * subdivisions), measured, exact, error});
                worst = std::max(worst, std::abs(error));
            }
    report.table("rolling", table);
    report.page_table("rolling", table, 4);
    report.fact("rolling", "worst_percent", worst, 2);
}

}  // namespace enduring::chapter08
