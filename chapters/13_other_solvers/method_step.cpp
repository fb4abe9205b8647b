#include "chapters/13_other_solvers/method_step.hpp"

namespace enduring {

Vec3 rotation_vector(const Quaternion& turn)
{
    const Eigen::AngleAxisd by(turn.w() < 0 ? Quaternion(-turn.coeffs()) : turn);
    return by.angle() * by.axis();
}

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

Vec3 MethodStep::difference(const ContactPoint& p, double elapsed) const
{
    Vec3 sum = a(p).pose.to_world(p.on_a) - b(p).pose.to_world(p.on_b) + elapsed * p.given;
    each_node(p, [&](const SoftNode& node, double weight) { sum += weight * node.place; });
    return sum;
}

Vec3 MethodStep::relative_velocity(const ContactPoint& p) const
{
    const MovingBody &one = a(p), &other = b(p);
    Vec3 sum = one.velocity + one.angular_velocity.cross(lever_a(p)) - other.velocity -
               other.angular_velocity.cross(lever_b(p)) + p.given;
    each_node(p, [&](const SoftNode& node, double weight) { sum += weight * node.velocity; });
    return sum;
}

void MethodStep::push(const ContactPoint& p, const Vec3& impulse)
{
    a(p).push(impulse, lever_a(p));
    b(p).push(-impulse, lever_b(p));
    each_node(p,
              [&](SoftNode& node, double weight) { node.velocity += weight * node.inverse_mass * impulse; });
}

double MethodStep::response(const ContactPoint& p, const Vec3& direction) const
{
    const auto of = [&](const MovingBody& body, const Vec3& r) {
        const Vec3 turning = r.cross(direction);
        return body.moves ? body.inverse_mass + turning.dot(body.inverse_inertia() * turning) : 0.0;
    };
    double sum = of(a(p), lever_a(p)) + of(b(p), lever_b(p));
    each_node(p, [&](const SoftNode& node, double weight) { sum += weight * weight * node.inverse_mass; });
    return sum;
}

}  // namespace enduring
