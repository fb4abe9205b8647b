#include "common/rigid/rigid_motion.hpp"

#include "common/input/input_error.hpp"
#include "common/rigid/free_rotation.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>

namespace enduring {
namespace {

/// Principal axes of an inertia tensor as the columns of a rotation, and the moments about them.
struct PrincipalAxes {
    Mat3 axes;
    Vec3 moments;
};

PrincipalAxes principal_axes(const Mat3& inertia)
{
    // A body that lies along its axes keeps them. For a cube any axes would do,
    // and rounding would choose some that are askew.
    const Vec3 diagonal = inertia.diagonal();
    const double coupling = (inertia - Mat3(diagonal.asDiagonal())).cwiseAbs().maxCoeff();
    if (inertia.allFinite() && diagonal.minCoeff() > 0 && coupling <= 1e-14 * diagonal.minCoeff())
        return {Mat3::Identity(), diagonal};

    const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia);
    if (!inertia.allFinite() || !(solver.eigenvalues().minCoeff() > 0))
        throw InputError("rigid body: the inertia has to be finite and positive definite");
    PrincipalAxes result{solver.eigenvectors(), solver.eigenvalues()};
    if (result.axes.determinant() < 0)
        result.axes.col(2) *= -1;  // a reflection is no pose
    return result;
}

//! [inverse_of_free]
/// How angular momentum about free axes turns a body whose turns about other axes are held: the inverse of
/// the inertia's free part, and zero elsewhere.
Mat3 inverse_of_free(const Mat3& inertia, const FreeDirections& free)
{
    const Mat3 chosen = free.rotation.asDiagonal(), along_axes = free.axes.transpose() * inertia * free.axes;
    Mat3 part = chosen * along_axes * chosen;
    for (int i = 0; i < 3; ++i)
        if (free.rotation[i] == 0)
            part(i, i) = along_axes(i, i);
    return free.axes * (chosen * part.inverse() * chosen) * free.axes.transpose();
}
//! [inverse_of_free]

}  // namespace

RigidMotion::RigidMotion(const MassProperties& properties, const Vec3& velocity, const Vec3& angular_velocity)
    : mass_(properties.mass)
{
    if (!(mass_ > 0) || !std::isfinite(mass_))
        throw InputError("rigid body: mass is " + std::to_string(mass_) +
                         " kg, it has to be positive and finite");
    if (!velocity.allFinite() || !angular_velocity.allFinite() || !properties.centre.allFinite())
        throw InputError("rigid body: position and velocities have to be finite");
    const PrincipalAxes principal = principal_axes(properties.inertia);
    principal_inertia_ = principal.moments;
    spin_momentum_ = properties.inertia * angular_velocity;

    velocity_ = velocity;
    angular_velocity_ = angular_velocity;
    place({properties.centre, Quaternion(principal.axes).normalized()});
}

void RigidMotion::place(const Pose& pose)
{
    pose_ = pose;
    const Mat3 axes = pose.orientation.toRotationMatrix();
    inverse_inertia_ = free_.hold_a_turn()
                           ? inverse_of_free(inertia_of(axes), free_)
                           : Mat3(axes * principal_inertia_.cwiseInverse().asDiagonal() * axes.transpose());
}

Mat3 RigidMotion::inertia_of(const Mat3& axes) const
{
    return axes * principal_inertia_.asDiagonal() * axes.transpose();
}

void RigidMotion::hold(const FreeDirections& free)
{
    constexpr double rounding = 1e-12;  // of axes that are turned
    const Vec3 moves = free.part(Vec3::Ones() - free.translation, velocity_),
               turns = free.part(Vec3::Ones() - free.rotation, angular_velocity_);
    if (moves.norm() > rounding * velocity_.norm() || turns.norm() > rounding * angular_velocity_.norm())
        throw InputError("rigid body: it moves along or about an axis that is held");
    free_ = free;
    place(pose_);
    velocity_ = free_.moving(velocity_);
    spin_momentum_ = free_.turning(spin_momentum_);
}

//! [pin]
/// About the pin the inertia is larger, by Steiner's theorem. All that follows is that of a body whose
/// translations are held.
void RigidMotion::pin(const Vec3& point, const Vec3& free_turns, const Mat3& axes)
{
    if (!velocity_.isZero(0))
        throw InputError("rigid body: the velocity of a body that is pinned follows from its turning");
    const Vec3 lever = pose_.position - point;
    const Mat3 steiner = mass_ * (lever.squaredNorm() * Mat3::Identity() - lever * lever.transpose()),
               inertia = inertia_of(pose_.orientation.toRotationMatrix()) + steiner;
    const PrincipalAxes principal = principal_axes(inertia);
    principal_inertia_ = principal.moments;
    pose_ = {point, Quaternion(principal.axes).normalized()};
    centre_in_body_ = pose_.orientation.conjugate() * lever;
    spin_momentum_ = inertia * angular_velocity_;
    hold({Vec3::Zero(), free_turns, axes});
}
//! [pin]

void RigidMotion::take(const State& state)
{
    place(state.pose);
    velocity_ = state.velocity;
    angular_velocity_ = state.angular_velocity;
    spin_momentum_ = state.spin_momentum;
}

Vec3 RigidMotion::spin_in_body_axes() const
{
    return (pose_.orientation.conjugate() * spin_momentum_).cwiseQuotient(principal_inertia_);
}

//! [predict]
void RigidMotion::predict(const Vec3& gravity, double dt)
{
    momentum_t0_ = linear_momentum();
    pushed_ = dt * mass_ * gravity;
    velocity_ += dt * free_.moving(gravity);
    if (is_off_centre())
        spin_momentum_ += free_.turning(dt * mass_ * lever().cross(gravity));
    if (free_.hold_a_turn()) {
        angular_velocity_ = mean_angular_velocity(dt);
        return;
    }
    // Left as it is, the angular velocity would hold neither energy nor momentum (see the page).
    const Vec3 w0 = spin_in_body_axes();
    const Vec3 w1 = freely_turned(principal_inertia_, w0, dt);
    angular_velocity_ = pose_.orientation * (0.5 * (w0 + w1));
}
//! [predict]

//! [held_turn]
/// The part of the momentum about free axes stays, while the body turns by the mean of the velocities at both
/// ends. About one axis this is exact. About two the energy is right to second order.
Vec3 RigidMotion::mean_angular_velocity(double dt) const
{
    const Mat3 axes = pose_.orientation.toRotationMatrix();
    const Vec3 w0 = inverse_inertia_ * spin_momentum_;
    Vec3 w1 = w0;
    for (int iteration = 0; iteration < 50; ++iteration) {
        const Vec3 mean = 0.5 * (w0 + w1);
        const Mat3 turned = Eigen::AngleAxisd(dt * mean.norm(), mean.stableNormalized()) * axes;
        const Vec3 next = inverse_of_free(inertia_of(turned), free_) * spin_momentum_;
        const bool settled = (next - w1).norm() <= 1e-15 * next.norm();
        w1 = next;
        if (settled)
            break;
    }
    return 0.5 * (w0 + w1);
}
//! [held_turn]

//! [predicted_pose]
Pose RigidMotion::predicted_pose(double dt) const
{
    // of no velocity: none
    const Eigen::AngleAxisd turn(dt * angular_velocity_.norm(), angular_velocity_.stableNormalized());
    return {pose_.position + dt * velocity_, (turn * pose_.orientation).normalized()};
}
//! [predicted_pose]

//! [apply_impulse]
void RigidMotion::apply_impulse(const Vec3& impulse, const Vec3& point)
{
    apply_momentum(impulse, (point - pose_.position).cross(impulse));
}

void RigidMotion::apply_momentum(const Vec3& momentum, const Vec3& turning)
{
    pushed_ += momentum;
    velocity_ += free_.moving(momentum) / mass_;
    angular_velocity_ += inverse_inertia_ * turning;
    spin_momentum_ += free_.turning(turning);
}
//! [apply_impulse]

//! [commit]
void RigidMotion::commit(double dt)
{
    place(predicted_pose(dt));
    // The momentum is what stays; which angular velocity belongs to it depends on how the body lies now.
    angular_velocity_ = free_.hold_a_turn() ? Vec3(inverse_inertia_ * spin_momentum_)
                                            : Vec3(pose_.orientation * spin_in_body_axes());
}
//! [commit]

Vec3 RigidMotion::velocity_at(const Vec3& point) const
{
    return velocity_ + angular_velocity_.cross(point - pose_.position);
}

Vec3 RigidMotion::angular_acceleration(const Vec3& gravity) const
{
    return inverse_inertia_ * (mass_ * lever().cross(gravity));
}

Vec3 RigidMotion::acceleration_at(const Vec3& point, const Vec3& gravity) const
{
    return free_.moving(gravity) + angular_acceleration(gravity).cross(point - pose_.position);
}

Mat3 RigidMotion::inverse_mass_at(const Vec3& point) const
{
    const Vec3 r = point - pose_.position;
    Mat3 lever;
    lever << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return free_.along_axes(free_.translation) / mass_ + lever * inverse_inertia_ * lever.transpose();
}

Vec3 RigidMotion::angular_momentum(const Vec3& about) const
{
    const Vec3 orbital = (pose_.position - about).cross(linear_momentum());
    if (free_.hold_a_turn())
        return orbital +
               inertia_of(pose_.orientation.toRotationMatrix()) * (inverse_inertia_ * spin_momentum_);
    return orbital + spin_momentum_;
}

double RigidMotion::kinetic_energy() const
{
    if (free_.hold_a_turn())
        return 0.5 * mass_ * velocity_.squaredNorm() +
               0.5 * spin_momentum_.dot(inverse_inertia_ * spin_momentum_);
    const Vec3 spin = spin_in_body_axes();
    return 0.5 * mass_ * velocity_.squaredNorm() + 0.5 * spin.dot(principal_inertia_.cwiseProduct(spin));
}

}  // namespace enduring
