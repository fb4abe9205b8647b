#include "chapters/12_joints/experiments/experiments.hpp"
#include "chapters/12_joints/experiments/machine.hpp"
#include "common/simulation/outside_load.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter12 {
namespace {
namespace door_parts {

constexpr double mass = 30, gravity = 9.81, width = 0.9, height = 2;

struct Door {
    double weight_off = 0;   ///< of the sum of the hinges' vertical forces, as a part of the weight
    double moment_off = 0;   ///< of the hinges' horizontal forces, as a part of what holds the door upright
    double most_uneven = 0;  ///< between the vertical forces of two hinges, as a part of the weight
    double turned = 0;       ///< how far it has turned [rad]
    double error = 0;
};

/// A door on hinges that all hold in all directions: more than are needed. It is let go with a turn of 1
/// rad/s and has nothing to stop it.
Door swing(int hinges, double duration)
{
    Machine machine(0.01);
    const Vec3 centre(width / 2, height / 2, 0), spin(0, 1, 0);
    const int leaf = machine.add_box(Vec3(width, height, 0.04), mass, centre, 0, spin.cross(centre), spin);
    for (int i = 0; i < hinges; ++i)
        machine.add_joint(JointKind::hinge, leaf, -1, Vec3(0, 0.2 + 1.6 * i / std::max(1, hinges - 1), 0),
                          Vec3::UnitY());
    const World& world = machine.scene.world;
    Door of;
    machine.run(duration, [&] {
        Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
        double least = 1e9, most = -1e9;
        for (const Joint& joint : world.joints) {
            sum += joint.force;
            moment += joint.torque + joint.b.point.cross(joint.force);
            least = std::min(least, joint.force.y());
            most = std::max(most, joint.force.y());
        }
        const Vec3 at_start = Vec3(world.bodies[0]->centre().x(), 0, world.bodies[0]->centre().z());
        const double needed = mass * gravity * width / 2;
        of.weight_off = std::max(of.weight_off, std::abs(sum.y() / (mass * gravity) - 1));
        of.moment_off = std::max(
            of.moment_off,
            std::abs(std::abs(moment.dot(at_start.normalized().cross(Vec3::UnitY()))) / needed - 1));
        of.most_uneven = std::max(of.most_uneven, (most - least) / (mass * gravity));
    });
    of.turned = world.joints[0].angle;
    of.error = machine.worst_error();
    return of;
}

/// A cube hangs on a weld; a force that grows by 100 N a second pulls it down. When does the weld give way
/// [N]?
double force_at_break(double dt, double breaks_at)
{
    Machine machine(dt);
    const int cube = machine.add_box(Vec3::Constant(0.1), 1, Vec3::Zero());
    const TimedVector pull({{0, Vec3::Zero()}, {10, Vec3(0, -1000, 0)}});
    machine.rigid(cube).add_load({.force = pull});
    machine.add_joint(JointKind::fixed, cube, -1, Vec3(0, 0.05, 0)).breaks_at = breaks_at;
    double broken = 0;
    machine.run(2, [&] {
        if (broken == 0 && machine.scene.world.joints[0].broken)
            broken = gravity + 100 * (machine.scene.world.time - dt / 2);  // what the step has on the mean
    });
    return broken;
}

}  // namespace door_parts
}  // namespace

/// A door with more hinges than it needs, and a weld that breaks.
void door(const RunOptions& options, Report& report)
{
    using namespace door_parts;
    const double duration = options.quick ? 1 : 5;
    Table table({"hinges", "weight_off", "most_uneven", "turned_rad", "joint_error_m"});
    double weight_off = 0, uneven = 0, error = 0, turned = 0;
    for (const int hinges : {1, 2, 3, 5}) {
        const Door of = swing(hinges, duration);
        table.add({static_cast<long>(hinges), of.weight_off, of.most_uneven, of.turned, of.error});
        weight_off = std::max(weight_off, of.weight_off);
        uneven = std::max(uneven, of.most_uneven);
        error = std::max(error, of.error);
        turned = std::max(turned, std::abs(of.turned - duration));
    }
    report.table("door", table);
    report.page_table("door", table, 2);
    Table welds({"breaks_at_n", "dt_s", "broke_at_n"});
    double off = 0;
    for (const double dt : {0.01, 0.001}) {
        const double broke = force_at_break(dt, 100);
        welds.add({100.0, dt, broke});
        off = std::max(off, std::abs(broke - 100) / (100 * dt));
    }
    report.table("weld", welds);
    report.page_table("weld", welds, 4);
    report.fact("door", "weight_off", weight_off, 2);
    report.fact("door", "uneven", uneven, 2);
    report.fact("door", "joint_error_m", error, 2);
    report.fact("door", "turned_off_rad", turned, 2);
    report.fact("door", "weld_steps_off", off, 2);
}

}  // namespace enduring::chapter12
