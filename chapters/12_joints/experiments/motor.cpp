#include "chapters/12_joints/experiments/experiments.hpp"
#include "chapters/12_joints/experiments/machine.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter12 {
namespace {
namespace motor_parts {

constexpr double mass = 10, gravity = 9.81, wanted = 1;

struct Lift {
    double acceleration = 0;  ///< at the start [m/s^2]
    double speed = 0;         ///< at the end [m/s]
    double force = 0;         ///< of the motor at the end [N]
};

/// A motor of this strength wants to lift a load with 1 m/s on a slider.
Lift lift(double most, double duration)
{
    Machine machine(0.01);
    const int load = machine.add_box(Vec3::Constant(0.2), mass, Vec3::Zero());
    Joint& slider = machine.add_joint(JointKind::slider, load, -1, Vec3::Zero(), Vec3::UnitY());
    slider.way.motor_speed = wanted;
    slider.way.motor_most = most;
    Lift of;
    const World& world = machine.scene.world;
    machine.run(duration, [&] {
        if (world.step == 3)
            of.acceleration = world.bodies[0]->mean_velocity().y() / world.time;
        of.speed = world.bodies[0]->mean_velocity().y();
        of.force = world.joints[0].way_force;
    });
    return of;
}

}  // namespace motor_parts
}  // namespace

/// A motor with a largest force against a load: what it cannot lift sinks, and what it can comes to the speed
/// that is wanted.
void motor(const RunOptions& options, Report& report)
{
    using namespace motor_parts;
    const double duration = options.quick ? 1 : 2;
    Table table({"most_n", "exact_m_per_s2", "acceleration_m_per_s2", "speed_m_per_s", "force_n"});
    double off = 0, speed_off = 0;
    for (const double part : {0.0, 0.5, 1.0, 1.1, 2.0, 3.0}) {
        const double most = part * mass * gravity, exact = (part - 1) * gravity;
        const Lift of = lift(most, duration);
        table.add({most, exact, of.acceleration, of.speed, of.force});
        off = std::max(off, std::abs(of.acceleration - exact));
        if (part >= 2)
            speed_off = std::max(speed_off, std::abs(of.speed / wanted - 1));
    }
    report.table("motor", table);
    report.page_table("motor", table, 3);
    report.fact("motor", "acceleration_off_m_per_s2", off, 2);
    report.fact("motor", "speed_off", speed_off, 2);
}

}  // namespace enduring::chapter12
