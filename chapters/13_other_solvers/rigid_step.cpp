#include "chapters/13_other_solvers/rigid_step.hpp"

#include "chapters/13_other_solvers/near_features.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/rigid_body.hpp"

#include <map>
#include <memory>
#include <utility>

namespace enduring {

Vec3 rotation_vector(const Quaternion& turn)
{
    const Eigen::AngleAxisd by(turn.w() < 0 ? Quaternion(-turn.coeffs()) : turn);
    return by.angle() * by.axis();
}

namespace {

MovingBody moving_body(const World& world, const Body& body, double dt)
{
    MovingBody moving;
    moving.size = body.size();
    if (body.is_static())
        return moving;
    const auto* const rigid = dynamic_cast<const RigidBody*>(&body);
    if (rigid == nullptr)
        throw InputError("body '" + body.name() + "' is deformable; this solver moves rigid bodies only");
    const RigidMotion& motion = rigid->motion();
    if (!motion.free_directions().hold_none())
        throw InputError("body '" + body.name() + "' is held; this solver moves free bodies only");
    moving.moves = true;
    moving.inverse_mass = 1 / motion.mass();
    moving.start = moving.pose = motion.pose();
    const Mat3 axes = moving.pose.orientation.toRotationMatrix();
    moving.inverse_in_body = axes.transpose() * motion.inverse_inertia() * axes;
    moving.inertia_in_body = moving.inverse_in_body.inverse();
    moving.gravity = body.gravity_on(world.gravity);
    moving.velocity = motion.velocity() - dt * moving.gravity;
    moving.angular_velocity = motion.angular_velocity();
    return moving;
}

/// A point of A or B in the coordinates of its body, and how it moves as given.
Vec3 point_of(const World& world, const Contact& contact, int from, int to, double tau)
{
    Vec3 point = Vec3::Zero();
    for (int i = from; i < to; ++i)
        point += std::abs(contact.weights[static_cast<std::size_t>(i)]) *
                 contact_vertex(world, contact, i, tau);
    return point;
}

ContactPoint contact_point(const World& world, const RigidStep& step, const Contact& contact,
                           const FrictionCoefficients& friction)
{
    const bool on_plane = contact.kind == ContactKind::vertex_plane;
    ContactPoint point;
    point.a = contact.body_a;
    point.b = on_plane ? static_cast<int>(world.bodies.size()) : contact.body_b;
    point.normal = contact.normal_t0;
    point.tangent_1 = point.normal.unitOrthogonal();
    point.tangent_2 = point.normal.cross(point.tangent_1);
    point.separation = separation_t0(world, contact);
    const int of_a = contact.vertices_of_a();
    const Vec3 p = point_of(world, contact, 0, of_a, 0);
    const Vec3 q = on_plane ? Vec3(p - point.separation * point.normal)
                            : point_of(world, contact, of_a, 4, 0);
    point.on_a = step.a(point).pose.to_body(p);
    point.on_b = step.b(point).pose.to_body(q);
    if (!step.a(point).moves)
        point.given += (point_of(world, contact, 0, of_a, 1) - p) / step.dt;
    if (!on_plane && !step.b(point).moves)
        point.given -= (point_of(world, contact, of_a, 4, 1) - q) / step.dt;
    const Vec3 running = running_of_surfaces(world, contact);
    point.given += running - point.normal.dot(running) * point.normal;
    const FrictionCoefficients& mu = pair_friction(world, contact, friction);
    point.mu_s = mu.mu_s;
    point.mu_d = mu.mu_d;
    point.restitution = pair_restitution(world, contact);
    point.key = key_of(contact);
    point.vertices = contact.vertices;
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto n = static_cast<std::size_t>(i);
        const MovingBody& body = i < of_a ? step.a(point) : step.b(point);
        point.corners[n] =
            body.pose.to_body(body_of_vertex(world, contact, i).contact_point(contact.vertices[n], 0));
    }
    return point;
}

/// What lasts beyond a step: the search's trees, and of each pair its impulse, which turns with body A.
class RigidRun {
public:
    RigidRun(const ContactParameters& parameters, RigidMethod method, PairSearch search)
        : friction_(coefficients_of(parameters.friction)), method_(std::move(method)),
          search_(std::move(search))
    {}

    void find(World& world, Contacts& contacts, double dt)
    {
        step_ = {};
        step_.dt = dt;
        for (const auto& body : world.bodies)
            step_.bodies.push_back(moving_body(world, *body, dt));
        step_.bodies.emplace_back();  // the ground
        contacts = search_(world);
        for (const Contact& contact : contacts) {
            step_.points.push_back(contact_point(world, step_, contact, friction_));
            ContactPoint& point = step_.points.back();
            if (const auto old = impulses_.find(point.key); old != impulses_.end())
                point.impulse = step_.a(point).pose.orientation * old->second;
        }
    }

    void solve(World& world, Contacts& contacts)
    {
        method_(step_);
        impulses_.clear();
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const ContactPoint& point = step_.points[i];
            contacts[i].impulse = point.normal.dot(point.impulse) * point.normal;
            contacts[i].friction = point.impulse - contacts[i].impulse;
            contacts[i].state = ContactState::answered;
            impulses_[point.key] = step_.a(point).pose.orientation.conjugate() * point.impulse;
        }
        move_bodies(world);
    }

    //! [leave]
    /// Behind the commit: velocities are those that the method ends with, whatever the way of the step was.
    void leave(World& world)
    {
        for (std::size_t i = 0; i < world.bodies.size(); ++i)
            if (!kicks_[i].isZero(0))
                world.bodies[i]->kick({}, kicks_[i], step_.dt);
    }
    //! [leave]

private:
    //! [move_bodies]
    /// Momenta with which the commit brings each body to the pose that the method has found; what the velocity at the end lacks comes behind it.
    void move_bodies(World& world)
    {
        kicks_.assign(world.bodies.size(), Eigen::VectorXd::Zero(6));
        for (std::size_t i = 0; i < world.bodies.size(); ++i) {
            const MovingBody& moving = step_.bodies[i];
            if (!moving.moves)
                continue;
            const Vec3 way = (moving.pose.position - moving.start.position) / step_.dt;
            const Vec3 turn =
                rotation_vector(moving.pose.orientation * moving.start.orientation.conjugate()) / step_.dt;
            Body& body = *world.bodies[i];
            const Eigen::VectorXd predicted = body.contact_velocity({});
            const Mat3 axes = moving.start.orientation.toRotationMatrix();
            const Mat3 inertia_t0 = axes * moving.inertia_in_body * axes.transpose();
            Eigen::VectorXd impulse(6);
            impulse << (way - predicted.head<3>()) / moving.inverse_mass,
                inertia_t0 * (turn - predicted.tail<3>());
            body.apply_contact_impulse({}, impulse);
            body.update_prediction(step_.dt);
            kicks_[i] << (moving.velocity - way) / moving.inverse_mass,
                moving.inertia() * (moving.angular_velocity - turn);
        }
    }
    //! [move_bodies]

    FrictionCoefficients friction_;
    RigidMethod method_;
    PairSearch search_;
    RigidStep step_;
    std::map<PairKey, Vec3> impulses_;  ///< in the axes of A
    std::vector<Eigen::VectorXd> kicks_;
};

}  // namespace

Mat3 MovingBody::turned(const Mat3& in_body) const
{
    const Mat3 axes = pose.orientation.toRotationMatrix();
    return axes * in_body * axes.transpose();
}

void MovingBody::move(double h)
{
    const Eigen::AngleAxisd turn(h * angular_velocity.norm(), angular_velocity.stableNormalized());
    pose = {pose.position + h * velocity, (turn * pose.orientation).normalized()};
}

void MovingBody::push(const Vec3& impulse, const Vec3& r)
{
    velocity += inverse_mass * impulse;
    if (moves)
        angular_velocity += inverse_inertia() * r.cross(impulse);
}

Vec3 RigidStep::difference(const ContactPoint& p, double elapsed) const
{
    return a(p).pose.to_world(p.on_a) - b(p).pose.to_world(p.on_b) + elapsed * p.given;
}

Vec3 RigidStep::relative_velocity(const ContactPoint& p) const
{
    const MovingBody &one = a(p), &other = b(p);
    return one.velocity + one.angular_velocity.cross(lever_a(p)) - other.velocity -
           other.angular_velocity.cross(lever_b(p)) + p.given;
}

void RigidStep::push(const ContactPoint& p, const Vec3& impulse)
{
    a(p).push(impulse, lever_a(p));
    b(p).push(-impulse, lever_b(p));
}

double RigidStep::response(const ContactPoint& p, const Vec3& direction) const
{
    const auto of = [&](const MovingBody& body, const Vec3& r) {
        const Vec3 turning = r.cross(direction);
        return body.moves ? body.inverse_mass + turning.dot(body.inverse_inertia() * turning) : 0.0;
    };
    return of(a(p), lever_a(p)) + of(b(p), lever_b(p));
}

Solver rigid_solver(const std::string& name, const ContactParameters& parameters, RigidMethod method,
                    PairSearch search)
{
    const auto run = std::make_shared<RigidRun>(parameters, std::move(method), std::move(search));
    Solver solver;
    solver.name = name;
    solver.append(StepStage::refresh, "find near features",
                  [run](World& world, Contacts& contacts, double dt) { run->find(world, contacts, dt); });
    solver.append(StepStage::refresh, name,
                  [run](World& world, Contacts& contacts, double) { run->solve(world, contacts); });
    solver.append(StepStage::settle, "leave velocities",
                  [run](World& world, Contacts&, double) { run->leave(world); });
    return solver;
}

Solver rigid_solver(const std::string& name, const ContactParameters& parameters, RigidMethod method,
                    const SearchSettings& search)
{
    const auto near = std::make_shared<NearFeatures>(search);
    return rigid_solver(name, parameters, std::move(method),
                        PairSearch([near](World& world) { return near->find(world); }));
}

}  // namespace enduring
