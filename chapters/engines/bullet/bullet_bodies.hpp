#pragma once

#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletSoftBody/btSoftBody.h>

#include <memory>

namespace enduring::bullet {

/// A body that Bullet moves, as probes and pictures see any other. Between predict() and commit() Bullet
/// steps its whole world and read_back() takes the new places over. Nothing but Bullet pushes it: passes of
/// ours have no business with it.
class BulletBody : public Body {
public:
    using Body::Body;

    /// positions_t1 from where Bullet has the body now.
    virtual void read_back() = 0;

    void predict(const Vec3&, double) final {}
    void update_prediction(double) final {}
    void commit(double) final { positions_t0_ = positions_t1_; }

    /// @throws std::logic_error  always
    void apply_impulse(int vertex, const Vec3& impulse) final;
    Mat3 inverse_mass(int vertex) const final;
};

class BulletRigidBody final : public BulletBody {
public:
    /// @param body   where it is, how it moves, its mass and inertia
    /// @param shape  in the body's own coordinates; has to outlive Bullet's steps
    BulletRigidBody(const RigidBody& body, btCollisionShape& shape);

    void read_back() override;
    Vec3 velocity(int vertex) const override;
    double mass() const override { return mass_; }
    Energy energy(const Vec3& gravity) const override;
    Vec3 linear_momentum() const override;
    Vec3 angular_momentum(const Vec3& about) const override;

    /// Shared with the world that steps it.
    const std::shared_ptr<btRigidBody>& shared_body() { return body_; }

private:
    Vec3 spin_momentum() const;  ///< about its centre [kg m^2/s]

    double mass_;
    Vec3 inertia_;  ///< along the body axes [kg m^2]
    std::vector<Vec3> body_points_;
    std::shared_ptr<btRigidBody> body_;
};

/// Bullet's deformable body of linear tetrahedra, over the corners of our elements; the other nodes of a
/// quadratic element follow in the middles of its edges. Energy and momenta are read with our elements.
class BulletSoftBody final : public BulletBody {
public:
    BulletSoftBody(const DeformableBody& body, btSoftBodyWorldInfo& world);

    void read_back() override;
    Vec3 velocity(int vertex) const override { return embedding_.at(vertex, elastic_.velocities()); }
    double mass() const override { return elastic_.mass(); }
    Energy energy(const Vec3& gravity) const override { return energy_of(elastic_, gravity); }
    Vec3 linear_momentum() const override { return elastic_.linear_momentum(); }
    Vec3 angular_momentum(const Vec3& about) const override { return elastic_.angular_momentum(about); }
    int inverted_elements() const override { return elastic_.inverted_elements(); }

    const std::shared_ptr<btSoftBody>& shared_body() { return body_; }

private:
    ElasticBody elastic_;
    SurfaceEmbedding embedding_;
    std::vector<int> corners_;  ///< node of our mesh of each of Bullet's
    std::shared_ptr<btSoftBody> body_;
};

}  // namespace enduring::bullet
