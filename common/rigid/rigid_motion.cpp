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
    inverse_inertia_ = axes * principal_inertia_.cwiseInverse().asDiagonal() * axes.transpose();
}

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
    velocity_ += dt * gravity;
    // Left as it is, the angular velocity would hold neither energy nor momentum (see the page).
    const Vec3 w0 = spin_in_body_axes();
    const Vec3 w1 = freely_turned(principal_inertia_, w0, dt);
    angular_velocity_ = pose_.orientation * (0.5 * (w0 + w1));
}
//! [predict]

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
    apply_momentum(impulse, (point - centre()).cross(impulse));
}

void RigidMotion::apply_momentum(const Vec3& momentum, const Vec3& turning)
{
    velocity_ += momentum / mass_;
    angular_velocity_ += inverse_inertia_ * turning;
    spin_momentum_ += turning;
}
//! [apply_impulse]

//! [commit]
void RigidMotion::commit(double dt)
{
    place(predicted_pose(dt));
    // The momentum is what stays; which angular velocity belongs to it depends on how the body lies now.
    angular_velocity_ = pose_.orientation * spin_in_body_axes();
}
//! [commit]

Vec3 RigidMotion::velocity_at(const Vec3& point) const
{
    return velocity_ + angular_velocity_.cross(point - centre());
}

Mat3 RigidMotion::inverse_mass_at(const Vec3& point) const
{
    const Vec3 r = point - centre();
    Mat3 lever;
    lever << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return Mat3::Identity() / mass_ + lever * inverse_inertia_ * lever.transpose();
}

Vec3 RigidMotion::angular_momentum(const Vec3& about) const
{
    return (centre() - about).cross(linear_momentum()) + spin_momentum_;
}

double RigidMotion::kinetic_energy() const
{
    const Vec3 spin = spin_in_body_axes();
    return 0.5 * mass_ * velocity_.squaredNorm() + 0.5 * spin.dot(principal_inertia_.cwiseProduct(spin));
}

}  // namespace enduring
