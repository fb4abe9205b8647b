#include "chapters/12_joints/experiments/experiments.hpp"
#include "chapters/12_joints/experiments/machine.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace enduring::chapter12 {
namespace {

struct Energies {
    double height = 0;  ///< what it can fall by, times its weight [J]
    double worst = 0,
           last = 0;  ///< change since the start, the largest, and the mean of the last tenth of the time [J]
    double error = 0;
    long halved = 0;
    std::vector<double> course{};  ///< the change, every 50 ms [J]
};

/// Two bars of 1 m and 1 kg, let go from the horizontal.
Energies swing_of_bars(double dt, double duration)
{
    Machine machine(dt);
    const int upper = machine.add_bar(Vec3::Zero(), Vec3(1, 0, 0), 1),
              lower = machine.add_bar(Vec3(1, 0, 0), Vec3(2, 0, 0), 1);
    machine.add_joint(JointKind::hinge, upper, -1, Vec3::Zero());
    machine.add_joint(JointKind::hinge, lower, upper, Vec3(1, 0, 0));
    const World& world = machine.scene.world;
    // velocities are half a step behind positions: this is what a step of a fall keeps
    const auto kept = [&] {
        double sum = total_energy(world).total();
        for (const auto& body : world.bodies)
            sum += dt / 2 * world.gravity.dot(body->linear_momentum());
        return sum;
    };
    const double start = kept();
    Energies of;
    of.height = 9.81 * (1.0 + 2.0);
    long counted = 0;
    machine.run(duration, [&] {
        const double change = kept() - start;
        of.worst = std::max(of.worst, std::abs(change));
        if (world.step % std::lround(0.05 / dt) == 0)
            of.course.push_back(change);
        if (world.time > 0.9 * duration) {
            of.last += change;
            ++counted;
        }
    });
    of.last /= static_cast<double>(std::max(1L, counted));
    of.error = machine.worst_error();
    of.halved = world.thrown_away;
    return of;
}

}  // namespace

/// A double pendulum without friction: what becomes of its energy, over the step.
void double_pendulum(const RunOptions& options, Report& report)
{
    const double duration = options.quick ? 5 : 60;
    Table table({"dt_s", "largest_change_percent", "change_at_end_percent", "joint_error_m", "halved"});
    double coarse = 0, fine = 0, error = 0, end = 0;
    std::vector<Energies> all;
    for (const double dt : {0.01, 0.005, 0.0025}) {
        const Energies of = swing_of_bars(dt, duration);
        table.add({dt, 100 * of.worst / of.height, 100 * of.last / of.height, of.error, of.halved});
        (dt == 0.01 ? coarse : fine) = of.worst / of.height;
        error = std::max(error, of.error);
        all.push_back(of);
        end = std::max(end, std::abs(of.last / of.height));
    }
    Table course({"time_s", "percent_10_ms", "percent_5_ms", "percent_2_5_ms"});
    for (std::size_t i = 0; i < all[0].course.size(); ++i) {
        const auto percent = [&](std::size_t run) { return 100 * all[run].course[i] / all[run].height; };
        course.add({0.05 * static_cast<double>(i + 1), percent(0), percent(1), percent(2)});
    }
    report.table("double_pendulum", table);
    report.table("double_pendulum_energy", course);
    report.plot("chapters/12_joints/plots/double_pendulum.gp");
    report.page_table("double_pendulum", table, 2);
    report.fact("double_pendulum", "coarse_percent", 100 * coarse, 2);
    report.fact("double_pendulum", "fine_percent", 100 * fine, 2);
    report.fact("double_pendulum", "end_percent", 100 * end, 2);
    report.fact("double_pendulum", "joint_error_m", error, 2);
}

}  // namespace enduring::chapter12
