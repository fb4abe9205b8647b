#include "common/rigid/rigid_motion.hpp"

#include "common/input/input_error.hpp"
#include "common/rigid/free_rotation.hpp"

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <Eigen/Eigenvalues>
#include <LinearMath/btTransformUtil.h>

#include <cmath>

namespace enduring {
namespace {

btVector3 to_bullet(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

btTransform to_bullet(const Pose& pose)
{
    const Quaternion& q = pose.orientation;
    return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), to_bullet(pose.position));
}

Pose from_bullet(const btTransform& transform)
{
    const btQuaternion q = transform.getRotation();
    return {from_bullet(transform.getOrigin()), Quaternion(q.w(), q.x(), q.y(), q.z()).normalized()};
}

/// Principal axes of an inertia tensor as the columns of a rotation, and the moments about them.
struct PrincipalAxes {
    Mat3 axes;
    Vec3 moments;
};

PrincipalAxes principal_axes(const Mat3& inertia)
{
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
        throw InputError("rigid body: mass is " + std::to_string(mass_) + " kg, it has to be positive and finite");
    if (!velocity.allFinite() || !angular_velocity.allFinite() || !properties.centre.allFinite())
        throw InputError("rigid body: position and velocities have to be finite");
    const PrincipalAxes principal = principal_axes(properties.inertia);
    principal_inertia_ = principal.moments;
    spin_momentum_ = properties.inertia * angular_velocity;

    // No shape and no motion state: collision and drawing are done elsewhere.
    const btRigidBody::btRigidBodyConstructionInfo info(mass_, nullptr, nullptr, to_bullet(principal_inertia_));
    body_ = std::make_unique<btRigidBody>(info);
    body_->setCenterOfMassTransform(to_bullet(Pose{properties.centre, Quaternion(principal.axes)}));
    body_->setLinearVelocity(to_bullet(velocity));
    body_->setAngularVelocity(to_bullet(angular_velocity));
}

RigidMotion::~RigidMotion() = default;
RigidMotion::RigidMotion(RigidMotion&&) noexcept = default;
RigidMotion& RigidMotion::operator=(RigidMotion&&) noexcept = default;

//! [predict]
void RigidMotion::predict(const Vec3& gravity, double dt)
{
    body_->setGravity(to_bullet(gravity));
    body_->applyGravity();
    body_->integrateVelocities(dt);
    body_->clearForces();

    // Bullet would leave the angular velocity as it is, which holds neither energy nor momentum (see the page).
    const Quaternion orientation = pose().orientation;
    const Vec3 w0 = (orientation.conjugate() * spin_momentum_).cwiseQuotient(principal_inertia_);
    const Vec3 w1 = freely_turned(principal_inertia_, w0, dt);
    body_->setAngularVelocity(to_bullet(orientation * (0.5 * (w0 + w1))));
}
//! [predict]

//! [predicted_pose]
Pose RigidMotion::predicted_pose(double dt) const
{
    // Bullet cuts a turn of more than pi/4 a step short. Shorter steps of the same constant velocity add up to the
    // same turn and never meet that limit.
    const double longest_turn = 0.75;
    const btVector3& spin = body_->getAngularVelocity();
    const int parts = 1 + static_cast<int>(std::fmin(spin.length() * dt / longest_turn, 1000));  // a NaN ends as one

    btTransform transform = body_->getCenterOfMassTransform();
    for (int part = 0; part < parts; ++part) {
        btTransform next;
        btTransformUtil::integrateTransform(transform, body_->getLinearVelocity(), spin, dt / parts, next);
        transform = next;
    }
    return from_bullet(transform);
}
//! [predicted_pose]

//! [apply_impulse]
void RigidMotion::apply_impulse(const Vec3& impulse, const Vec3& point)
{
    const Vec3 lever = point - centre();
    body_->applyImpulse(to_bullet(impulse), to_bullet(lever));
    spin_momentum_ += lever.cross(impulse);
}
//! [apply_impulse]

//! [commit]
void RigidMotion::commit(double dt)
{
    body_->setCenterOfMassTransform(to_bullet(predicted_pose(dt)));
    // The momentum is what stays; which angular velocity belongs to it depends on how the body lies now.
    const Quaternion orientation = pose().orientation;
    const Vec3 in_body = (orientation.conjugate() * spin_momentum_).cwiseQuotient(principal_inertia_);
    body_->setAngularVelocity(to_bullet(orientation * in_body));
}
//! [commit]

Pose RigidMotion::pose() const { return from_bullet(body_->getCenterOfMassTransform()); }
Vec3 RigidMotion::centre() const { return from_bullet(body_->getCenterOfMassPosition()); }
Vec3 RigidMotion::velocity() const { return from_bullet(body_->getLinearVelocity()); }
Vec3 RigidMotion::angular_velocity() const { return from_bullet(body_->getAngularVelocity()); }

Vec3 RigidMotion::velocity_at(const Vec3& point) const
{
    return velocity() + angular_velocity().cross(point - centre());
}

Mat3 RigidMotion::inverse_mass_at(const Vec3& point) const
{
    const Vec3 r = point - centre();
    Mat3 lever;
    lever << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return Mat3::Identity() / mass_ + lever * inverse_inertia() * lever.transpose();
}

Mat3 RigidMotion::inverse_inertia() const
{
    const btMatrix3x3& basis = body_->getCenterOfMassTransform().getBasis();
    Mat3 axes;
    axes << basis[0][0], basis[0][1], basis[0][2], basis[1][0], basis[1][1], basis[1][2], basis[2][0], basis[2][1], basis[2][2];
    return axes * principal_inertia_.cwiseInverse().asDiagonal() * axes.transpose();
}

Vec3 RigidMotion::angular_momentum(const Vec3& about) const
{
    return (centre() - about).cross(linear_momentum()) + spin_momentum_;
}

double RigidMotion::kinetic_energy() const
{
    const Vec3 in_body = pose().orientation.conjugate() * spin_momentum_;
    return 0.5 * mass_ * velocity().squaredNorm() + 0.5 * in_body.dot(in_body.cwiseQuotient(principal_inertia_));
}

}  // namespace enduring
