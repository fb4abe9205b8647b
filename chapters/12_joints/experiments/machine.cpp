#include "chapters/12_joints/experiments/machine.hpp"

#include "chapters/12_joints/solver.hpp"
#include "common/geometry/box_shapes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace enduring::chapter12 {

int Machine::add_box(const Vec3& size, double mass, const Vec3& centre, double angle, const Vec3& velocity,
                     const Vec3& spin)
{
    SurfaceMesh mesh = box(size);
    const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
    for (Vec3& vertex : mesh.vertices)
        vertex = centre + turn * vertex;
    const auto number = static_cast<int>(scene.world.bodies.size());
    scene.world.bodies.push_back(std::make_unique<RigidBody>(
        "body " + std::to_string(number), mesh, with_mass(mass_properties(mesh, 1), mass), velocity, spin));
    return number;
}

int Machine::add_bar(const Vec3& from, const Vec3& to, double mass)
{
    const Vec3 along = to - from;
    return add_box(Vec3(along.norm(), 0.01, 0.01), mass, (from + to) / 2, std::atan2(along.y(), along.x()));
}

Joint& Machine::add_joint(JointKind kind, int a, int b, const Vec3& at, const Vec3& axis)
{
    return scene.world.joints.emplace_back(make_joint(
        scene.world, "joint " + std::to_string(scene.world.joints.size()), kind, a, b, at, axes_about(axis)));
}

RigidBody& Machine::rigid(int body)
{
    return dynamic_cast<RigidBody&>(*scene.world.bodies[static_cast<std::size_t>(body)]);
}

void Machine::run(double duration, const std::function<void()>& after)
{
    const Solver solver = chapter12_solver(scene.contact);
    Contacts contacts;
    const long steps = std::lround(duration / scene.dt);
    for (long step = 0; step < steps; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        for (const Joint& joint : scene.world.joints)
            worst_ = std::max(worst_, error_of(scene.world, joint));
        after();
    }
}

double error_of(const World& world, const Joint& joint)
{
    if (joint.broken)
        return 0;
    const JointMeasure of = joint_measure(joint.kind, committed_pose(world, joint), joint.angle);
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
        if (locks_along(joint.kind, i))
            worst = std::max(worst, std::abs(of.along[i]));
        if (locks_about(joint.kind, i))
            worst = std::max(worst, std::abs(of.about[i]));
    }
    if (joint.kind == JointKind::distance && joint.way.low == joint.way.high)
        worst = std::max(worst, std::abs(of.along[0] - joint.way.low));
    return worst;
}

}  // namespace enduring::chapter12
