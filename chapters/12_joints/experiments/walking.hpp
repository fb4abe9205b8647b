#pragma once

#include "chapters/12_joints/experiments/machine.hpp"

#include <array>

namespace enduring::chapter12 {

/// A plan of steps on level ground, by its times. The middle of the hips swings from foot to foot as a sine,
/// and goes forward with a steady speed after the first two steps.
struct Gait {
    double step_time = 0.8;                  ///< from foot to foot [s]
    double step_length = 0.12, lift = 0.04;  ///< [m]
    double sway = 0.05;                      ///< of the hips to each side [m]
    double crouch = 0.05;                    ///< by which bent knees lower the hips [m]

    /// The middle of the hips, from where it stands at the start [m].
    Vec3 hips(double time) const;
    /// A foot, from where it stands at the start [m].
    /// @param side  1 at positive z, or -1
    Vec3 foot(int side, double time) const;
};

/// Two legs of five bodies, hips and chest: 12 bodies and 11 hinges, each with limits and a motor.
class Walker {
public:
    static constexpr int bodies = 12;
    static constexpr double thigh = 0.3, shank = 0.3, half_hips = 0.09;  ///< [m]

    explicit Walker(const Gait& gait, double dt = 0.01);

    Machine machine;
    const Contacts& contacts() const { return contacts_; }  ///< after the last step
    double mass() const;                                    ///< [kg]
    const Body& hips() const { return *machine.scene.world.bodies[0]; }
    /// Walks on.
    /// @param after  called after each step
    void walk(
        double duration, const std::function<void()>& after = [] {});
    /// The largest difference of a turn from the plan so far [rad].
    double off_plan() const { return off_plan_; }
    /// The largest error of what its hinges lock, so far [m, rad].
    double joint_error() const { return joint_error_; }

private:
    void add_leg(int side);
    Joint& add_hinge(int a, int b, const Vec3& at, const Vec3& axis, double low, double high);
    void follow_plan(double time);
    void compare();

    Gait gait_;
    Contacts contacts_;
    double off_plan_ = 0, joint_error_ = 0;
};

/// Turns of a leg's five hinges from the hips down: hip to the side, hip, knee, ankle, ankle to the side. The
/// foot stays level.
/// @param foot  from the leg's hip [m]
std::array<double, 5> leg_turns(const Vec3& foot);

}  // namespace enduring::chapter12
