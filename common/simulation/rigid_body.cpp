#include "common/simulation/rigid_body.hpp"

#include <stdexcept>
#include <utility>

namespace enduring {
namespace {

/// A copy of what an impulse changes, and what it takes to change it.
class RigidTrial final : public Trial {
public:
    RigidTrial(const RigidMotion& motion, std::span<const Vec3> vertices)
        : vertices_(vertices), centre_(motion.pose().position), mass_(motion.mass()),
          free_(motion.free_directions()), inverse_inertia_(motion.inverse_inertia()),
          velocity_(motion.velocity()), angular_velocity_(motion.angular_velocity())
    {}

    void push(int vertex, const Vec3& impulse) override
    {
        velocity_ += free_.moving(impulse) / mass_;
        angular_velocity_ += inverse_inertia_ * lever(vertex).cross(impulse);
    }
    Vec3 velocity(int vertex) override { return velocity_ + angular_velocity_.cross(lever(vertex)); }

private:
    Vec3 lever(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)] - centre_; }

    std::span<const Vec3> vertices_;  ///< at the start of the step
    Vec3 centre_;
    double mass_;
    FreeDirections free_;
    Mat3 inverse_inertia_;
    Vec3 velocity_, angular_velocity_;
};

void place(const Pose& pose, const std::vector<Vec3>& points, std::vector<Vec3>& positions)
{
    for (std::size_t i = 0; i < points.size(); ++i)
        positions[i] = pose.to_world(points[i]);
}

}  // namespace

RigidBody::RigidBody(std::string name, const SurfaceMesh& mesh, const MassProperties& properties,
                     const Vec3& velocity, const Vec3& angular_velocity)
    : Body(std::move(name), topology_of(mesh)), motion_(properties, velocity, angular_velocity)
{
    positions_t0_ = mesh.vertices;
    positions_t1_ = mesh.vertices;
    take_body_points();
    measure();
}

void RigidBody::take_body_points()
{
    body_points_.clear();
    body_points_.reserve(positions_t0_.size());
    for (const Vec3& vertex : positions_t0_)
        body_points_.push_back(motion_.pose().to_body(vertex));
}

void RigidBody::pin(const Vec3& point, const Vec3& free_turns, const Mat3& axes)
{
    if (!loads_.empty())
        throw std::logic_error("rigid body '" + name() + "': it is pinned before it gets loads");
    motion_.pin(point, free_turns, axes);
    take_body_points();
}

void RigidBody::add_load(const OutsideLoad& load)
{
    const Pose& pose = motion_.pose();
    const Quaternion to_body = pose.orientation.conjugate();
    OutsideLoad own = load;
    if (load.point || motion_.centre() != pose.position)  // a force on the centre turns a body about its pin
        own.point = pose.to_body(load.point.value_or(motion_.centre()));
    if (load.turns_along) {
        own.force = load.force.turned(to_body);
        own.torque = load.torque.turned(to_body);
    }
    loads_.push_back(own);
}

//! [apply_loads]
/// With the lever and the axes of the start of the step, as all impulses have them.
void RigidBody::apply_loads(double dt)
{
    const Quaternion& orientation = motion_.pose().orientation;
    load_momentum_.setZero();
    load_turning_.setZero();
    for (const OutsideLoad& load : loads_) {
        Vec3 impulse = load.force.integral(time_, time_ + dt),
             turning = load.torque.integral(time_, time_ + dt);
        if (load.turns_along) {
            impulse = orientation * impulse;
            turning = orientation * turning;
        }
        const Vec3 lever = orientation * load.point.value_or(Vec3::Zero());
        if (load.spring)
            impulse += dt * load.spring->force_on(motion_.pose().position + lever);
        turning += lever.cross(impulse);
        load_momentum_ += impulse;
        load_turning_ += turning;
    }
    motion_.apply_momentum(load_momentum_, load_turning_);
}
//! [apply_loads]

void RigidBody::predict(const Vec3& gravity, double dt)
{
    lever_orientation_t1_ = motion_.predicted_pose(dt).orientation;
    motion_.predict(gravity_on(gravity), dt);
    if (!loads_.empty())
        apply_loads(dt);
    update_prediction(dt);
}

void RigidBody::update_prediction(double dt)
{
    const Pose pose = motion_.predicted_pose(dt);
    place(pose, body_points_, positions_t1_);
    place(pose, contact_points_, contact_t1_);
}

void RigidBody::commit(double dt)
{
    motion_.commit(dt);
    place(motion_.pose(), body_points_, positions_t1_);
    place(motion_.pose(), contact_points_, contact_t1_);
    positions_t0_ = positions_t1_;
    contact_t0_ = contact_t1_;
}

void RigidBody::take_contact_surface(const std::vector<Vec3>& shape)
{
    contact_points_ = contact_t0_ = shape;
    place(motion_.pose(), contact_points_, contact_t0_);
    contact_t1_ = contact_t0_;
}

// The lever is that of the start of the step: one prediction, one place for all its impulses.
void RigidBody::apply_impulse(int vertex, const Vec3& impulse)
{
    motion_.apply_impulse(impulse, start_of(vertex));
}

Vec3 RigidBody::velocity(int vertex) const { return motion_.velocity_at(start_of(vertex)); }

Mat3 RigidBody::inverse_mass(int vertex) const { return motion_.inverse_mass_at(start_of(vertex)); }

ContactMass RigidBody::contact_mass(std::span<const int>) const
{
    ContactMass of{Eigen::MatrixXd::Zero(6, 6), Eigen::MatrixXd::Zero(6, 6)};
    of.mass.topLeftCorner<3, 3>().diagonal().setConstant(motion_.mass());
    of.mass.bottomRightCorner<3, 3>() = motion_.inverse_inertia().inverse();
    of.response.topLeftCorner<3, 3>().diagonal().setConstant(1 / motion_.mass());
    of.response.bottomRightCorner<3, 3>() = motion_.inverse_inertia();
    if (const FreeDirections& free = motion_.free_directions(); free.hold_a_turn()) {
        // a held turn has some mass of its own, which nothing moves: contact_motion() leaves it out
        of.response.bottomRightCorner<3, 3>() +=
            free.along_axes((Vec3::Ones() - free.rotation) / motion_.mass());
        of.mass.bottomRightCorner<3, 3>() = Mat3(of.response.bottomRightCorner<3, 3>()).inverse();
    }
    return of;
}

// All impulses of a step have one lever, however often they are mended: that of the end to which the body
// turns as fast as it does at the start, until it is told to follow the motion found. So what rests has the
// levers of its rest, whatever torques it bears.
VertexMotion RigidBody::contact_motion(std::span<const int> touched, std::size_t index, double tau) const
{
    const Vec3& point = body_points_[static_cast<std::size_t>(touched[index])];
    const Vec3 r = lerp(motion_.pose().orientation * point, lever_orientation_t1_ * point, tau);
    VertexMotion motion;
    motion.rate = motion_of_point(r);
    return motion;
}

Eigen::Matrix<double, 3, 6> RigidBody::motion_of_point(const Vec3& r) const
{
    Eigen::Matrix<double, 3, 6> rate;
    rate.leftCols<3>().setIdentity();
    rate.rightCols<3>() << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;  // omega x r
    const FreeDirections& free = motion_.free_directions();
    if (!free.hold_none()) {
        rate.leftCols<3>() *= free.along_axes(free.translation);
        rate.rightCols<3>() *= free.along_axes(free.rotation);
    }
    return rate;
}

Eigen::Matrix<double, 3, 6> RigidBody::motion_of_turn() const
{
    Eigen::Matrix<double, 3, 6> rate = Eigen::Matrix<double, 3, 6>::Zero();
    const FreeDirections& free = motion_.free_directions();
    rate.rightCols<3>() = free.along_axes(free.rotation);
    return rate;
}

bool RigidBody::follow_levers(double least_turn, double dt)
{
    const Quaternion predicted = motion_.predicted_pose(dt).orientation;
    if (lever_orientation_t1_.angularDistance(predicted) <= least_turn)
        return false;
    lever_orientation_t1_ = predicted;
    return true;
}

void RigidBody::apply_contact_impulse(std::span<const int>, const Eigen::VectorXd& impulse)
{
    motion_.apply_momentum(impulse.head<3>(), impulse.tail<3>());
}

Eigen::VectorXd RigidBody::contact_velocity(std::span<const int>) const
{
    return (Eigen::VectorXd(6) << motion_.velocity(), motion_.angular_velocity()).finished();
}

double RigidBody::pressing_force(double dt) const
{
    return (load_momentum_.norm() + load_turning_.norm() / size()) / dt;
}

std::unique_ptr<Trial> RigidBody::begin_trial() const
{
    return std::make_unique<RigidTrial>(motion_, positions_t0_);
}

//! [turned_lever_work]
double RigidBody::turned_lever_work(const Vec3& gravity, double dt) const
{
    const Pose& pose = motion_.pose();
    const Vec3 centre = motion_.centre();
    if (centre == pose.position)
        return 0;
    const Vec3 moved = motion_.predicted_pose(dt).to_world(pose.to_body(centre)) - centre;
    return mass() * gravity_on(gravity).dot(dt * motion_.velocity_at(centre) - moved);
}
//! [turned_lever_work]

void RigidBody::visit_state(StateArchive& archive)
{
    Body::visit_state(archive);
    RigidMotion::State state = motion_.state();
    archive(state.pose.position);
    archive(state.pose.orientation);
    archive(state.velocity);
    archive(state.angular_velocity);
    archive(state.spin_momentum);
    if (archive.reads()) {
        motion_.take(state);
        place(motion_.pose(), contact_points_, contact_t0_);
    }
}

void RigidBody::move_with(const Vec3& velocity, const Vec3& angular_velocity)
{
    RigidMotion::State state = motion_.state();
    state.velocity = velocity;
    state.angular_velocity = angular_velocity;
    state.spin_momentum.setZero();
    if (!angular_velocity.isZero(0))
        state.spin_momentum = motion_.inverse_inertia().inverse() * angular_velocity;
    motion_.take(state);
}

Energy RigidBody::energy(const Vec3& gravity) const
{
    Energy energy;
    energy.kinetic = motion_.kinetic_energy();
    energy.gravitational = -mass() * gravity_on(gravity).dot(motion_.centre());
    return energy;
}

}  // namespace enduring
