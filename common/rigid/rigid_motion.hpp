#pragma once

#include "common/geometry/vector.hpp"
#include "common/rigid/mass_properties.hpp"

namespace enduring {

/// Where a rigid body is: body coordinates to world coordinates. Their origin is the centre of mass, or of a
/// body that is pinned its pin; their axes are the principal ones of the inertia about it.
struct Pose {
    Vec3 position = Vec3::Zero();                     ///< of the origin [m]
    Quaternion orientation = Quaternion::Identity();  ///< unit length

    Vec3 to_world(const Vec3& body_point) const { return position + orientation * body_point; }
    Vec3 to_body(const Vec3& world_point) const { return orientation.conjugate() * (world_point - position); }
};

/// Along and about which axes a body can move: 1 where it is free, 0 where it is held.
struct FreeDirections {
    Vec3 translation = Vec3::Ones();  ///< of the centre of mass
    Vec3 rotation = Vec3::Ones();
    Mat3 axes =
        Mat3::Identity();  ///< in the columns, of length 1 and at right angles; they stand still in the world

    /// The matrix that has these numbers along the axes.
    Mat3 along_axes(const Vec3& numbers) const { return axes * numbers.asDiagonal() * axes.transpose(); }
    /// The part of a vector along the axes that are marked by a 1.
    Vec3 part(const Vec3& marked, const Vec3& vector) const
    {
        return axes * marked.cwiseProduct(axes.transpose() * vector);
    }
    Vec3 moving(const Vec3& vector) const { return part(translation, vector); }  ///< along free translations
    Vec3 turning(const Vec3& vector) const { return part(rotation, vector); }    ///< about free axes

    bool hold_none() const { return translation.minCoeff() > 0 && rotation.minCoeff() > 0; }
    bool hold_a_turn() const { return rotation.minCoeff() == 0; }
};

/// The motion of one rigid body, in steps of the thesis' scheme: predict, push, commit.
///
/// The free rotation is the energy and momentum conserving step of Simo and Wong
/// (1991); the turn of a step is the exponential map.
///
/// Between predict() and commit(), angular_velocity() is the constant one that turns the body through the
/// step; after commit() it is the one the body has at that moment.
class RigidMotion {
public:
    /// Starts where the mesh of `properties` lies in world coordinates.
    /// @param velocity          of the centre of mass [m/s]
    /// @param angular_velocity  in world axes [rad/s]
    /// @throws InputError  mass not positive, inertia not positive definite, or a velocity not finite
    explicit RigidMotion(const MassProperties& properties, const Vec3& velocity = Vec3::Zero(),
                         const Vec3& angular_velocity = Vec3::Zero());

    /// Takes the coordinates out that are held: their velocities are zero for good, whatever pushes.
    /// @throws InputError  a velocity along or about what is held
    void hold(const FreeDirections& free);
    /// Holds a point [m] of the body, as a hinge or a ball joint does: it stays where it is in the world, and
    /// the body turns about it, about the free axes alone. Three coordinates remain at most. Body coordinates
    /// begin at the pin from now on.
    /// @param free_turns  1 for each of the axes about which it may turn, 0 for the others
    /// @param axes        as those of FreeDirections
    /// @throws InputError  a velocity of the centre of mass (it follows from the turning), or a turn about
    ///     what is held
    void pin(const Vec3& point, const Vec3& free_turns, const Mat3& axes = Mat3::Identity());
    const FreeDirections& free_directions() const { return free_; }

    /// Velocities of the step from gravity [m/s^2] and the free rotation over dt [s] (thesis 3.3, 3.6).
    void predict(const Vec3& gravity, double dt);
    /// The pose that commit(dt) would produce with the present velocities (thesis 3.2, 3.8).
    Pose predicted_pose(double dt) const;
    /// Adds an impulse [N s] at a point [m] of the world, with its lever
    /// from the committed pose (thesis 3.9 to 3.12).
    void apply_impulse(const Vec3& impulse, const Vec3& point);
    /// The same by its effect: a momentum [N s] and an angular momentum about the pose's position [N m s].
    void apply_momentum(const Vec3& momentum, const Vec3& turning);
    /// The predicted pose becomes the pose.
    void commit(double dt);

    /// What changes from step to step.
    struct State {
        Pose pose;
        Vec3 velocity, angular_velocity, spin_momentum;
    };
    State state() const { return {pose_, velocity_, angular_velocity_, spin_momentum_}; }
    void take(const State& state);

    const Pose& pose() const { return pose_; }  ///< committed
    /// of mass [m]
    Vec3 centre() const { return is_off_centre() ? pose_.to_world(centre_in_body_) : pose_.position; }
    /// of the centre of mass [m/s]
    Vec3 velocity() const { return is_off_centre() ? velocity_at(centre()) : velocity_; }
    const Vec3& angular_velocity() const { return angular_velocity_; }  ///< in world axes [rad/s]
    /// Velocity [m/s] of the material point that is at `point` in the committed pose.
    Vec3 velocity_at(const Vec3& point) const;
    /// Velocity change at `point` per impulse there [1/kg]: 1/m + [r]x J^-1
    /// [r]x^T with r from the centre to the point.
    Mat3 inverse_mass_at(const Vec3& point) const;

    /// What gravity [m/s^2] alone makes of the motion of the point at `point` in the committed pose: less
    /// than itself where the body is held [m/s^2].
    Vec3 acceleration_at(const Vec3& point, const Vec3& gravity) const;
    /// The turning part of it [rad/s^2].
    Vec3 angular_acceleration(const Vec3& gravity) const;

    /// What the lock has given since predict(): the momentum [N s] that changed though nothing pushed. It
    /// does no work.
    Vec3 lock_impulse() const { return linear_momentum() - momentum_t0_ - pushed_; }

    /// about the pose's position, world axes, of the committed pose [1/(kg m^2)]; of the free turns alone,
    /// and zero for those held
    const Mat3& inverse_inertia() const { return inverse_inertia_; }

    double mass() const { return mass_; }
    Vec3 linear_momentum() const { return mass_ * velocity(); }  ///< [kg m/s]
    Vec3 angular_momentum(const Vec3& about) const;              ///< orbital and own [kg m^2/s]
    double kinetic_energy() const;                               ///< of translation and rotation [J]

private:
    void place(const Pose& pose);
    Mat3 inertia_of(const Mat3& axes) const;      ///< in world axes, if the body's lie like this [kg m^2]
    Vec3 mean_angular_velocity(double dt) const;  ///< of a free step while turns are held [rad/s]
    Vec3 spin_in_body_axes() const;  ///< the angular velocity that belongs to the momentum [rad/s]
    bool is_off_centre() const { return !centre_in_body_.isZero(0); }  ///< the origin, which is a pin
    /// from the origin to the centre of mass [m]
    Vec3 lever() const { return pose_.orientation * centre_in_body_; }

    double mass_ = 0;
    Vec3 principal_inertia_ = Vec3::Zero();  ///< about the body's origin, along its axes [kg m^2]
    Vec3 centre_in_body_ = Vec3::Zero();     ///< of mass [m]; not zero where a pin is off it
    Pose pose_;
    Mat3 inverse_inertia_ = Mat3::Zero();                             ///< belongs to the pose
    Vec3 velocity_ = Vec3::Zero(), angular_velocity_ = Vec3::Zero();  ///< of the body's origin [m/s]; [rad/s]
    FreeDirections free_;
    /// at predict(), and by gravity and impulses since [N s]
    Vec3 momentum_t0_ = Vec3::Zero(), pushed_ = Vec3::Zero();
    /// angular momentum about the origin, world axes: what a free body keeps; without its parts about axes
    /// that are held
    Vec3 spin_momentum_ = Vec3::Zero();
};

}  // namespace enduring
