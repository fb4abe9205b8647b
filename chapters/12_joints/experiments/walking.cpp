#include "chapters/12_joints/experiments/walking.hpp"

#include "chapters/12_joints/solver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter12 {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double ankle_height = 0.07, waist_turn = 0.15;

/// From 0 to 1, and level at both ends.
double smooth(double part)
{
    const double x = std::clamp(part, 0.0, 1.0);
    return x * x * x * (10 + x * (6 * x - 15));
}

}  // namespace

Vec3 Gait::hips(double time) const
{
    const double steps = time / step_time, started = smooth(steps / 2);
    const double ahead = std::clamp(steps - 2, 0.0, 1.0),  // gets its speed in the third step
        way = ahead * ahead / 2 + std::max(0.0, steps - 3);
    return {step_length * way, -crouch * started, -sway * started * std::sin(pi * steps)};
}

Vec3 Gait::foot(int side, double time) const
{
    constexpr double up = 0.2, down = 0.8;  // part of the step in which the foot moves
    const double steps = time / step_time;
    const int now = static_cast<int>(std::floor(steps));
    const bool swings = now >= 2 && (now % 2 == 0) == (side > 0);
    const auto stands = [&](int step) { return step < 3 ? 0.0 : hips((step + 0.5) * step_time).x(); };
    if (!swings)
        return {stands(now), 0, 0};
    const double part = std::clamp((steps - now - up) / (down - up), 0.0, 1.0), from = stands(now - 1),
                 to = stands(now + 1);
    return {from + (to - from) * smooth(part), lift * std::pow(4 * part * (1 - part), 3), 0};
}

std::array<double, 5> leg_turns(const Vec3& foot)
{
    const double roll = std::atan2(-foot.z(), -foot.y()), down = std::hypot(foot.y(), foot.z()),
                 length = std::hypot(foot.x(), down);
    const double bend = 2 * std::acos(std::min(1.0, length / (Walker::thigh + Walker::shank))),
                 lean = std::atan2(foot.x(), down);
    return {roll, lean + bend / 2, -bend, bend / 2 - lean, -roll};
}

Walker::Walker(const Gait& gait, double dt) : machine(dt), gait_(gait)
{
    Scene& scene = machine.scene;
    scene.world.planes.push_back({.name = "ground"});
    scene.contact.friction = MassSplitting{.mu_s = 0.8, .mu_d = 0.7};
    const double hip = ankle_height + thigh + shank;
    machine.add_box(Vec3(0.12, 0.08, 0.26), 3, Vec3(0, hip + 0.07, 0));
    const int chest = machine.add_box(Vec3(0.16, 0.28, 0.28), 6, Vec3(0, hip + 0.27, 0));
    add_hinge(chest, 0, Vec3(0, hip + 0.12, 0), Vec3::UnitY(), -0.6, 0.6);
    add_leg(1);
    add_leg(-1);
}

void Walker::add_leg(int side)
{
    const double z = side * half_hips, hip = ankle_height + thigh + shank, knee = ankle_height + shank;
    const int block = machine.add_box(Vec3(0.09, 0.07, 0.07), 0.8, Vec3(0, hip, z)),
              upper = machine.add_box(Vec3(0.08, 0.24, 0.08), 2, Vec3(0, hip - thigh / 2, z)),
              lower = machine.add_box(Vec3(0.06, 0.24, 0.06), 1.5, Vec3(0, knee - shank / 2, z)),
              ankle = machine.add_box(Vec3(0.06, 0.05, 0.06), 0.4, Vec3(0, ankle_height, z)),
              foot = machine.add_box(Vec3(0.26, 0.04, 0.15), 1, Vec3(0.03, 0.02, z));
    add_hinge(block, 0, Vec3(0, hip, z), Vec3::UnitX(), -0.6, 0.6);
    add_hinge(upper, block, Vec3(0, hip, z), Vec3::UnitZ(), -1, 1.6);
    add_hinge(lower, upper, Vec3(0, knee, z), Vec3::UnitZ(), -2.4, 0.01);
    add_hinge(ankle, lower, Vec3(0, ankle_height, z), Vec3::UnitZ(), -1, 1.2);
    add_hinge(foot, ankle, Vec3(0, ankle_height, z), Vec3::UnitX(), -0.6, 0.6);
}

Joint& Walker::add_hinge(int a, int b, const Vec3& at, const Vec3& axis, double low, double high)
{
    Joint& hinge = machine.add_joint(JointKind::hinge, a, b, at, axis);
    hinge.turn.low = low;
    hinge.turn.high = high;
    hinge.turn.motor_most = 80;
    hinge.turn.motor_speed = 20;
    hinge.turn.motor_target = 0;
    return hinge;
}

double Walker::mass() const
{
    double sum = 0;
    for (const auto& body : machine.scene.world.bodies)
        sum += body->mass();
    return sum;
}

void Walker::follow_plan(double time)
{
    std::vector<Joint>& joints = machine.scene.world.joints;
    const double started = smooth(time / gait_.step_time / 2);
    joints[0].turn.motor_target = waist_turn * started * std::cos(pi * time / gait_.step_time);
    for (const int side : {1, -1}) {
        const Vec3 stretched(0, -thigh - shank, 0);
        const auto turns = leg_turns(stretched + gait_.foot(side, time) - gait_.hips(time));
        for (std::size_t i = 0; i < turns.size(); ++i)
            joints[(side > 0 ? 1 : 6) + i].turn.motor_target = turns[i];
    }
}

void Walker::compare()
{
    const World& world = machine.scene.world;
    for (const Joint& joint : world.joints) {
        off_plan_ = std::max(off_plan_, std::abs(joint.angle - *joint.turn.motor_target));
        joint_error_ = std::max(joint_error_, error_of(world, joint));
    }
}

void Walker::walk(double duration, const std::function<void()>& after)
{
    Scene& scene = machine.scene;
    const Solver solver = chapter12_solver(scene.contact);
    for (long step = std::lround(duration / scene.dt); step > 0; --step) {
        follow_plan(scene.world.time + scene.dt);
        advance(scene.world, contacts_, solver, scene.dt);
        compare();
        after();
    }
}

}  // namespace enduring::chapter12
