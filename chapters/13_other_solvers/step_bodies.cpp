#include "chapters/13_other_solvers/step_bodies.hpp"

#include "chapters/13_other_solvers/near_features.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace enduring {
namespace {

[[noreturn]] void refuse(const Body& body, const std::string& why)
{
    throw InputError("body '" + body.name() + "' " + why);
}

MovingBody moving_body(const World& world, const Body& body, double dt)
{
    MovingBody moving;
    moving.size = body.size();
    if (body.is_static())
        return moving;
    const RigidMotion& motion = dynamic_cast<const RigidBody&>(body).motion();
    if (!motion.free_directions().hold_none())
        refuse(body, "is held; this solver moves free bodies only");
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

/// What a method cannot move is refused, and not moved by another law.
void check_soft(const DeformableBody& body, SoftBodies soft)
{
    const ElasticMaterial& material = body.elastic().material();
    if (soft == SoftBodies::refused)
        refuse(body, "is deformable; this solver moves rigid bodies only");
    if (body.elastic().mesh().basis() != Basis::linear)
        refuse(body, "has quadratic elements; this solver moves linear ones only");
    if (soft == SoftBodies::corotated && material.law == ElasticLaw::neo_hookean)
        refuse(body, "is Neo-Hookean; this solver moves corotated elements only");
    if (material.mass_damping > 0 || material.stiffness_damping > 0)
        refuse(body, "has a damped material; this solver moves undamped ones only");
    if (body.is_driven())
        refuse(body, "is driven; this solver moves free bodies only");
}

void append_soft_body(const World& world, std::size_t index, const DeformableBody& body, MethodStep& step)
{
    step.soft.push_back({&body, index, step.nodes.size()});
    MovingBody& place = step.bodies.back();
    place.size = body.size();
    place.is_soft = true;
    place.gravity = body.gravity_on(world.gravity);
    const ElasticBody& elastic = body.elastic();
    for (int n = 0; n < elastic.node_count(); ++n) {
        SoftNode node;
        if (!elastic.is_fixed(n)) {
            node.inverse_mass = elastic.inverse_masses()[n];
            node.gravity = place.gravity;
            node.velocity = elastic.start_velocities().col(n);
        }
        node.start = node.place = elastic.positions().col(n);
        step.nodes.push_back(node);
    }
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

int node_of(const MethodStep& step, const Contact& contact, int corner)
{
    const std::size_t body = body_index(contact, corner);
    const auto soft = std::find_if(step.soft.begin(), step.soft.end(),
                                   [body](const SoftBody& one) { return one.body == body; });
    if (soft == step.soft.end())
        return -1;
    const int vertex = contact.vertices[static_cast<std::size_t>(corner)];
    return static_cast<int>(soft->first) + soft->of->embedding().own_node(vertex);
}

}  // namespace

MethodStep step_bodies(const World& world, double dt, SoftBodies soft)
{
    MethodStep step;
    step.dt = dt;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const auto* const deformable = dynamic_cast<const DeformableBody*>(world.bodies[i].get());
        step.bodies.push_back(deformable ? MovingBody{} : moving_body(world, *world.bodies[i], dt));
        if (deformable == nullptr)
            continue;
        check_soft(*deformable, soft);
        append_soft_body(world, i, *deformable, step);
    }
    step.bodies.emplace_back();  // the ground
    return step;
}

ContactPoint contact_point(const World& world, const MethodStep& step, const Contact& contact,
                           const FrictionCoefficients& friction)
{
    const bool on_plane = contact.on_plane();
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
    const MovingBody &a = step.a(point), &b = step.b(point);
    point.on_a = a.is_soft ? Vec3(Vec3::Zero()) : a.pose.to_body(p);
    point.on_b = b.is_soft ? Vec3(Vec3::Zero()) : b.pose.to_body(q);
    if (!a.moves && !a.is_soft)
        point.given += (point_of(world, contact, 0, of_a, 1) - p) / step.dt;
    if (!on_plane && !b.moves && !b.is_soft)
        point.given -= (point_of(world, contact, of_a, 4, 1) - q) / step.dt;
    const Vec3 running = running_of_surfaces(world, contact);
    point.given += running - point.normal.dot(running) * point.normal;
    const FrictionCoefficients& mu = pair_friction(world, contact, friction);
    point.mu_s = mu.mu_s;
    point.mu_d = mu.mu_d;
    point.restitution = pair_restitution(world, contact);
    point.key = key_of(contact);
    point.vertices = contact.vertices;
    point.weights = contact.weights;
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto n = static_cast<std::size_t>(i);
        point.nodes[n] = node_of(step, contact, i);
        point.corners[n] =
            (i < of_a ? a : b)
                .pose.to_body(body_of_vertex(world, contact, i).contact_point(contact.vertices[n], 0));
    }
    return point;
}

}  // namespace enduring
