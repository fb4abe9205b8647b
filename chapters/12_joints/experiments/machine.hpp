#pragma once

#include "common/scenes/scene.hpp"
#include "common/simulation/make_joint.hpp"
#include "common/simulation/rigid_body.hpp"

#include <functional>
#include <string>

namespace enduring::chapter12 {

/// Boxes and joints, put together by an experiment.
struct Machine {
    Scene scene;

    explicit Machine(double dt) { scene.dt = dt; }
    Machine(double dt, const Vec3& gravity) : Machine(dt) { scene.world.gravity = gravity; }

    /// @param size   edges before it is turned [m]
    /// @param angle  about z [rad]
    /// @return  its index
    int add_box(const Vec3& size, double mass, const Vec3& centre, double angle = 0,
                const Vec3& velocity = Vec3::Zero(), const Vec3& spin = Vec3::Zero());
    /// A thin bar of 1 cm between two points of the plane z = 0, about which its motion stays.
    int add_bar(const Vec3& from, const Vec3& to, double mass);
    Joint& add_joint(JointKind kind, int a, int b, const Vec3& at, const Vec3& axis = Vec3::UnitZ());
    RigidBody& rigid(int body);

    /// Takes steps until a time, and calls after each of them.
    void run(
        double duration, const std::function<void()>& after = [] {});
    /// The largest error of what joints lock [m, rad], over all of them and all steps that were run.
    double worst_error() const { return worst_; }

private:
    double worst_ = 0;
};

/// How far a joint's ends are from where it holds them, the largest number [m, rad].
double error_of(const World& world, const Joint& joint);

}  // namespace enduring::chapter12
