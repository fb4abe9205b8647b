#include "chapters/12_joints/experiments/experiments.hpp"
#include "chapters/12_joints/experiments/machine.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace enduring::chapter12 {
namespace {
namespace pendulum_parts {

constexpr double length = 1, edge = 0.1, gravity = 9.81;

/// Of a cube of this edge that swings about an axis at the end of a massless arm [s].
double exact_period(double amplitude)
{
    const double inertia_over_mass = length * length + edge * edge / 6;
    return 4 * std::sqrt(inertia_over_mass / (gravity * length)) *
           std::comp_ellint_1(std::sin(amplitude / 2));
}

struct Swing {
    double period = 0;   ///< mean of all whole ones [s]
    double highest = 0;  ///< angle after the first period [rad]
    double error = 0;
};

Swing swing(double amplitude, double dt, int periods)
{
    Machine machine(dt);
    const Vec3 centre = length * Vec3(std::sin(amplitude), -std::cos(amplitude), 0);
    const int bob = machine.add_box(Vec3::Constant(edge), 1, centre, amplitude);
    machine.add_joint(JointKind::hinge, bob, -1, Vec3::Zero());
    const Joint& hinge = machine.scene.world.joints.front();
    Swing of;
    std::vector<double> crossings;  // from the right to the left, through the lowest point
    double before = amplitude;
    machine.run((periods + 0.5) * exact_period(amplitude), [&] {
        const double now = amplitude + hinge.angle, time = machine.scene.world.time;
        if (before > 0 && now <= 0)
            crossings.push_back(time - dt * now / (now - before));
        if (crossings.size() > 1)
            of.highest = std::max(of.highest, now);
        before = now;
    });
    of.period = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
    of.error = machine.worst_error();
    return of;
}

}  // namespace pendulum_parts
}  // namespace

/// A cube on a hinge swings: its period against the elliptic integral, over the amplitude and the step.
void pendulum(const RunOptions& options, Report& report)
{
    using namespace pendulum_parts;
    const int periods = options.quick ? 4 : 20;
    Table table({"amplitude_deg", "dt_s", "exact_period_s", "off_ppm", "lost_percent", "joint_error_m"});
    double worst_off = 0, worst_error = 0, worst_lost = 0;
    for (const double degrees : {1.0, 10.0, 30.0, 60.0})
        for (const double dt : {0.01, 0.005, 0.0025}) {
            const double amplitude = degrees * std::numbers::pi / 180, exact = exact_period(amplitude);
            const Swing of = swing(amplitude, dt, periods);
            const double off = of.period / exact - 1,
                         lost = 1 - (1 - std::cos(of.highest)) / (1 - std::cos(amplitude));
            table.add({degrees, dt, exact, 1e6 * off, 100 * lost, of.error});
            worst_error = std::max(worst_error, of.error);
            worst_lost = std::max(worst_lost, std::abs(lost));
            if (dt == 0.01)
                worst_off = std::max(worst_off, std::abs(off));
        }
    report.table("pendulum", table);
    report.page_table("pendulum", table, 3);
    report.fact("pendulum", "off_percent", 100 * worst_off, 2);
    report.fact("pendulum", "lost_percent", 100 * worst_lost, 2);
    report.fact("pendulum", "joint_error_m", worst_error, 2);
}

}  // namespace enduring::chapter12
