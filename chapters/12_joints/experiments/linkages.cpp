#include "chapters/12_joints/experiments/experiments.hpp"
#include "chapters/12_joints/experiments/machine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter12 {
namespace {
namespace linkages_parts {

constexpr double crank = 0.3, rod = 1, speed = 2 * std::numbers::pi;  // [m, m, rad/s]

struct Path {
    double off = 0;          ///< largest distance from the formula [m]
    double speed_error = 0;  ///< of the motor, largest part
    double error = 0;
    double far = 0;  ///< how far the point has travelled between its ends [m]
};

void drive(Joint& hinge)
{
    hinge.turn.motor_speed = speed;
    hinge.turn.motor_most = 1e4;
}

/// A motor turns a crank; a rod pushes a piston on a slider.
Path slider_crank(double dt, double duration)
{
    Machine machine(dt);
    const int arm = machine.add_bar(Vec3::Zero(), Vec3(crank, 0, 0), 1),
              link = machine.add_bar(Vec3(crank, 0, 0), Vec3(crank + rod, 0, 0), 1),
              piston = machine.add_box(Vec3::Constant(0.1), 2, Vec3(crank + rod, 0, 0));
    drive(machine.add_joint(JointKind::hinge, arm, -1, Vec3::Zero()));
    machine.add_joint(JointKind::hinge, link, arm, Vec3(crank, 0, 0));
    machine.add_joint(JointKind::hinge, piston, link, Vec3(crank + rod, 0, 0));
    machine.add_joint(JointKind::slider, piston, -1, Vec3(crank + rod, 0, 0), Vec3::UnitX());
    const World& world = machine.scene.world;
    Path path;
    double least = 1e9, most = -1e9, before = 0;
    machine.run(duration, [&] {
        const double angle = world.joints[0].angle, x = world.bodies[2]->centre().x();
        const double exact = crank * std::cos(angle) +
                             std::sqrt(rod * rod - std::pow(crank * std::sin(angle), 2));
        path.off = std::max(path.off, std::abs(x - exact));
        if (world.step > 1)  // the first step brings it to its speed
            path.speed_error = std::max(path.speed_error, std::abs((angle - before) / (dt * speed) - 1));
        before = angle;
        least = std::min(least, x);
        most = std::max(most, x);
    });
    path.error = machine.worst_error();
    path.far = most - least;
    return path;
}

/// The point at these distances from two others, above their line.
Vec3 apex(const Vec3& one, double from_one, const Vec3& other, double from_other)
{
    const Vec3 along = other - one;
    const double d = along.norm(), x = (d * d + from_one * from_one - from_other * from_other) / (2 * d),
                 y = std::sqrt(std::max(0.0, from_one * from_one - x * x));
    return one + x * along / d + y * Vec3::UnitZ().cross(along) / d;
}

/// A motor turns a crank of 0.3 m; a coupler of 1 m drives a rocker of 0.8 m, whose pin is 1.1 m from the
/// crank's.
Path four_bar(double dt, double duration)
{
    constexpr double coupler = 1, rocker = 0.8;
    const Vec3 pin(1.1, 0, 0), start(0, crank, 0), knee = apex(start, coupler, pin, rocker);
    Machine machine(dt);
    const int arm = machine.add_bar(Vec3::Zero(), start, 1), link = machine.add_bar(start, knee, 1),
              swing = machine.add_bar(pin, knee, 1);
    drive(machine.add_joint(JointKind::hinge, arm, -1, Vec3::Zero()));
    machine.add_joint(JointKind::hinge, link, arm, start);
    machine.add_joint(JointKind::hinge, swing, link, knee);
    machine.add_joint(JointKind::hinge, swing, -1, pin);
    const World& world = machine.scene.world;
    Path path;
    machine.run(duration, [&] {
        const double angle = std::numbers::pi / 2 + world.joints[0].angle;
        const Vec3 end = crank * Vec3(std::cos(angle), std::sin(angle), 0),
                   middle = (end + apex(end, coupler, pin, rocker)) / 2;
        path.off = std::max(path.off, (world.bodies[1]->centre() - middle).norm());
        path.far = std::max(path.far, (world.bodies[1]->centre() - (start + knee) / 2).norm());
    });
    path.error = machine.worst_error();
    return path;
}

/// Watt's linkage: two arms between pins that are 2 a apart, and a coupler of 2 c whose middle goes nearly
/// straight where a^2 = b^2 + c^2.
namespace watt {

constexpr double arm = 1, half_coupler = 0.25;
const double half_base = std::hypot(arm, half_coupler);
/// From the pins' middle, along the coupler as it lies there [m].
const Vec3 tangent(half_coupler / half_base, arm / half_base, 0);

/// The point of Watt's curve beside another one, as far from the middle between the pins. The coupler's half
/// h has |h - a| = sqrt(b^2 - r^2), which gives its angle; the middle lies at right angles to h - a.
Vec3 on_curve(const Vec3& near)
{
    const double r = near.norm(),
                 cosine = (r * r + 2 * half_coupler * half_coupler) / (2 * half_base * half_coupler),
                 sine = std::sqrt(1 - cosine * cosine);
    const Vec3 across = Vec3(half_coupler * sine, half_base - half_coupler * cosine, 0).normalized();
    return std::copysign(r, near.dot(across)) * across;
}

/// How far the curve leaves its tangent, to the first order that is not zero.
double bend(double r) { return std::pow(r, 5) / (8 * std::pow(arm, 3) * half_coupler); }

}  // namespace watt

struct WattPath {
    Path path;
    double straight = 0,
           straight_exact = 0;  ///< largest distance from the tangent on 40 cm, and its formula [m]
};

/// A motor swings one arm of Watt's linkage by 0.4 rad to both sides.
WattPath watt_linkage(double dt, double duration)
{
    const Vec3 pin(watt::half_base, 0, 0), end = watt::half_coupler * watt::tangent;
    Machine machine(dt);
    const int right = machine.add_bar(pin, end, 1), coupler = machine.add_bar(end, -end, 1),
              left = machine.add_bar(-pin, -end, 1);
    drive(machine.add_joint(JointKind::hinge, right, -1, pin));
    machine.add_joint(JointKind::hinge, coupler, right, end);
    machine.add_joint(JointKind::hinge, coupler, left, -end);
    machine.add_joint(JointKind::hinge, left, -1, -pin);
    World& world = machine.scene.world;
    WattPath of;
    machine.run(duration, [&] {
        JointDrive& motor = world.joints[0].turn;
        motor.motor_speed = std::copysign(1, world.joints[0].angle > 0.4    ? -1
                                             : world.joints[0].angle < -0.4 ? 1
                                                                            : motor.motor_speed);
        const Vec3 middle = world.bodies[1]->centre();
        of.path.off = std::max(of.path.off, (middle - watt::on_curve(middle)).norm());
        of.path.far = std::max(of.path.far, 2 * middle.norm());
        if (middle.norm() < 0.2) {
            of.straight = std::max(of.straight, middle.cross(watt::tangent).norm());
            of.straight_exact = std::max(of.straight_exact, watt::bend(middle.norm()));
        }
    });
    of.path.error = machine.worst_error();
    return of;
}

/// Two shafts with 40 degrees between them and Cardan's joint: the second turns unevenly.
Path cardan(double dt, double duration)
{
    const double bend = 40 * std::numbers::pi / 180;
    const Vec3 first = Vec3::UnitX(), second(std::cos(bend), std::sin(bend), 0);
    Machine machine(dt);
    const int driving = machine.add_bar(-first, Vec3::Zero(), 1),
              driven = machine.add_bar(Vec3::Zero(), second, 1);
    drive(machine.add_joint(JointKind::hinge, driving, -1, -first, first));
    machine.add_joint(JointKind::hinge, driven, -1, second, second);
    const Vec3 one = first.cross(second).normalized(), other = first.cross(one);
    Mat3 axes;
    axes << one, other, one.cross(other);
    machine.scene.world.joints.push_back(
        make_joint(machine.scene.world, "cross", JointKind::universal, driven, driving, Vec3::Zero(), axes));
    const World& world = machine.scene.world;
    Path path;
    machine.run(duration, [&] {
        const double in = world.joints[0].angle, out = world.joints[1].angle;
        // A's arm of the cross begins at right angles to both shafts: tan(out) = tan(in) / cos(bend), whole
        // turns counted
        const double exact = in + std::remainder(std::atan2(std::sin(in), std::cos(in) * std::cos(bend)) - in,
                                                 2 * std::numbers::pi);
        const double otherwise = in +
                                 std::remainder(std::atan2(std::sin(in) * std::cos(bend), std::cos(in)) - in,
                                                2 * std::numbers::pi);
        path.off = std::max(path.off, std::min(std::abs(out - exact), std::abs(out - otherwise)));
        path.far = std::max(path.far, std::abs(out - in));
    });
    path.error = machine.worst_error();
    return path;
}

}  // namespace linkages_parts
}  // namespace

/// Closed loops of joints, driven by a motor: the path of a point against the formula of the machine.
void linkages(const RunOptions& options, Report& report)
{
    using namespace linkages_parts;
    const double duration = options.quick ? 1 : 10;
    Table table({"linkage", "dt_s", "off_path_m", "range_m", "joint_error_m"});
    double off = 0, error = 0;
    const auto add = [&](const char* name, double dt, const Path& path) {
        table.add({name, dt, path.off, path.far, path.error});
        off = std::max(off, path.off);
        error = std::max(error, path.error);
    };
    double missed = 0;
    WattPath watt;
    for (const double dt : {0.01, 0.005}) {
        const Path piston = slider_crank(dt, duration);
        missed = std::max(missed, piston.speed_error);
        add("slider-crank", dt, piston);
        add("four-bar", dt, four_bar(dt, duration));
        add("Cardan", dt, cardan(dt, duration));
        watt = watt_linkage(dt, 2 * duration);
        add("Watt", dt, watt.path);
    }
    report.table("linkages", table);
    report.page_table("linkages", table, 2);
    report.fact("linkages", "off_m", off, 2);
    report.fact("linkages", "joint_error_m", error, 2);
    report.fact("linkages", "watt_straight_mm", 1000 * watt.straight, 2);
    report.fact("linkages", "watt_exact_mm", 1000 * watt.straight_exact, 2);
    report.fact("linkages", "speed_missed", missed, 2);
}

}  // namespace enduring::chapter12
