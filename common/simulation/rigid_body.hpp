#pragma once

#include "common/geometry/meshes.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/rigid/rigid_motion.hpp"
#include "common/simulation/body.hpp"
#include "common/simulation/outside_load.hpp"

namespace enduring {

/// A rigid body as the contact code sees it: surface points fixed in the body, so that an impulse at one of
/// them moves them all, and the inverse mass at a point is a full 3x3 matrix.
class RigidBody final : public Body, public ContactCoordinates {
public:
    /// @param mesh              closed surface where it starts in the world [m], or points and edges alone
    /// @param properties        of that mesh, in the same coordinates
    /// @param velocity          of the centre of mass [m/s]
    /// @param angular_velocity  in world axes [rad/s]
    /// @throws InputError       a surface or mass properties that no rigid body can have
    RigidBody(std::string name, const SurfaceMesh& mesh, const MassProperties& properties,
              const Vec3& velocity = Vec3::Zero(), const Vec3& angular_velocity = Vec3::Zero());

    /// It acts from now on; any number of them. A body that is pinned is pinned before.
    void add_load(const OutsideLoad& load);
    /// Takes coordinates out, for good.
    /// @throws InputError  the body moves along or about what is held
    void hold(const FreeDirections& free) { motion_.hold(free); }
    /// The same of a point of the body, for good: a hinge or a ball joint (RigidMotion::pin).
    void pin(const Vec3& point, const Vec3& free_turns, const Mat3& axes = Mat3::Identity());

    void predict(const Vec3& gravity, double dt) override;
    void update_prediction(double dt) override;
    void commit(double dt) override;

    void apply_impulse(int vertex, const Vec3& impulse) override;
    Vec3 velocity(int vertex) const override;
    double turning_speed() const override { return motion_.angular_velocity().norm(); }
    Mat3 inverse_mass(int vertex) const override;

    ContactCoordinates& contact_coordinates() override { return *this; }
    ContactMass contact_mass(std::span<const int> touched) const override;
    VertexMotion contact_motion(std::span<const int> touched, std::size_t index, double tau) const override;
    bool follow_levers(double least_turn, double dt) override;
    void apply_contact_impulse(std::span<const int> touched, const Eigen::VectorXd& impulse) override;
    Eigen::VectorXd contact_velocity(std::span<const int> touched) const override;

    std::unique_ptr<Trial> begin_trial() const override;

    bool is_driven() const override
    {
        return Body::is_driven() || !loads_.empty() || !motion_.free_directions().hold_none();
    }
    /// Between steps: it moves so from now on. A body that is held has to rest.
    /// @param velocity          of the centre of mass [m/s]
    /// @param angular_velocity  in world axes [rad/s]
    void move_with(const Vec3& velocity, const Vec3& angular_velocity);
    double pressing_force(double dt) const override;
    double driven_work(double /*dt*/) const override
    {
        return load_momentum_.dot(motion_.velocity_at(motion_.pose().position)) +
               load_turning_.dot(motion_.angular_velocity());
    }
    double turned_lever_work(const Vec3& gravity, double dt) const override;
    Vec3 acceleration(int vertex, const Vec3& gravity) const override
    {
        return motion_.acceleration_at(start_of(vertex), gravity_on(gravity));
    }
    std::span<const Vec3> shape() const override { return body_points_; }
    void take_contact_surface(const std::vector<Vec3>& shape) override;
    void visit_state(StateArchive& archive) override;

    double mass() const override { return motion_.mass(); }
    Energy energy(const Vec3& gravity) const override;
    Vec3 linear_momentum() const override { return motion_.linear_momentum(); }
    Vec3 angular_momentum(const Vec3& about) const override { return motion_.angular_momentum(about); }

    const RigidMotion& motion() const { return motion_; }
    /// How a point of the body moves with its coordinates in contact, velocity and angular velocity, by the
    /// lever from the origin of its pose [m]: nothing along or about what is held.
    Eigen::Matrix<double, 3, 6> motion_of_point(const Vec3& lever) const;
    /// How it turns with them.
    Eigen::Matrix<double, 3, 6> motion_of_turn() const;

private:
    const Vec3& start_of(int vertex) const { return positions_t0_[vertex]; }
    void take_body_points();

    void apply_loads(double dt);

    RigidMotion motion_;
    std::vector<OutsideLoad> loads_;  ///< points, and what turns along, in body coordinates
    Vec3 load_momentum_ = Vec3::Zero(), load_turning_ = Vec3::Zero();
    /// at the end of the step: as it turns at the start, then as follow_levers() found it
    Quaternion lever_orientation_t1_ = Quaternion::Identity();
    std::vector<Vec3> body_points_;     ///< surface vertices in body coordinates [m]
    std::vector<Vec3> contact_points_;  ///< the same of a surface that was taken for contact [m]
};

}  // namespace enduring
