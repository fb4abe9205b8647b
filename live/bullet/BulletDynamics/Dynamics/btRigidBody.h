#pragma once

#include <LinearMath/btTransform.h>

/// Bullet is no library for the browser here. The live figures compile the base's rigid bodies against this: the few lines of
/// btRigidBody that common/rigid/rigid_motion.cpp calls, with Bullet's own vectors and transforms, which are headers.
class btRigidBody {
public:
    struct btRigidBodyConstructionInfo {
        btRigidBodyConstructionInfo(btScalar mass, void*, void*, const btVector3& inertia) : mass_(mass), inertia_(inertia) {}
        btScalar mass_;
        btVector3 inertia_;
    };

    explicit btRigidBody(const btRigidBodyConstructionInfo& info) : mass_(info.mass_), inertia_(info.inertia_) {}

    void setGravity(const btVector3& gravity) { gravity_ = gravity; }
    void applyGravity() { force_ += mass_ * gravity_; }
    void clearForces() { force_.setZero(); }
    void integrateVelocities(btScalar dt) { velocity_ += (dt / mass_) * force_; }
    void applyImpulse(const btVector3& impulse, const btVector3& lever)
    {
        velocity_ += impulse / mass_;
        const btMatrix3x3& axes = pose_.getBasis();
        spin_ += axes * ((lever.cross(impulse) * axes) / inertia_);
    }

    const btVector3& getLinearVelocity() const { return velocity_; }
    const btVector3& getAngularVelocity() const { return spin_; }
    const btVector3& getCenterOfMassPosition() const { return pose_.getOrigin(); }
    const btTransform& getCenterOfMassTransform() const { return pose_; }
    void setLinearVelocity(const btVector3& velocity) { velocity_ = velocity; }
    void setAngularVelocity(const btVector3& spin) { spin_ = spin; }
    void setCenterOfMassTransform(const btTransform& pose) { pose_ = pose; }

private:
    btScalar mass_;
    btVector3 inertia_, gravity_{0, 0, 0}, force_{0, 0, 0}, velocity_{0, 0, 0}, spin_{0, 0, 0};
    btTransform pose_ = btTransform::getIdentity();
};
