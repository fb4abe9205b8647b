#include "chapters/07_implicit_contact/grain_friction.hpp"
#include "chapters/07_implicit_contact/step_problem.hpp"

#include <algorithm>

namespace enduring {

Vec3 normal_of(const PairStep& step, double tau)
{
    if (step.plane_normal)
        return *step.plane_normal;
    return lerp(step.t0.side_1, step.t1.side_1, tau)
        .cross(lerp(step.t0.side_2, step.t1.side_2, tau))
        .stableNormalized();
}

namespace {

/// p - q at one end of the step, for a plane from any of its points [m].
Vec3 relative_position(const World& world, const Contact& contact,
                       std::span<const Vec3> (Body::*positions)() const)
{
    const auto vertex = [&](std::size_t i) -> const Vec3& {
        const Body& body = body_of_vertex(world, contact, static_cast<int>(i));
        return (body.*positions)()[static_cast<std::size_t>(contact.vertices[i])];
    };
    if (contact.on_plane())
        return vertex(0) - world.planes[static_cast<std::size_t>(contact.body_b)].point;
    return contact.weights[0] * vertex(0) + contact.weights[1] * vertex(1) + contact.weights[2] * vertex(2) +
           contact.weights[3] * vertex(3);
}

//! [push_between_paths]
/// Of the normals between two, the one along which nothing moves; or the nearer one of the two.
Vec3 normal_of_path(const Vec3& one, const Vec3& other, const Vec3& velocity)
{
    const double a = one.dot(velocity), part = a / (a - other.dot(velocity));
    // where neither meets the velocity, that is no number, and max() takes the first of its two
    return (one + std::min(1.0, std::max(0.0, part)) * (other - one)).normalized();
}

/// A vertex that slides along a surface which bends is pushed along the mean of two normals: that of the path
/// on which it came, and that of this step's path. So what it loses in speed along the first it gains along
/// the second. Its depth at the end stays that below the surface.
void push_between_paths(const Contact& contact, const StepLaw& step, PairRow& row)
{
    const double depth_t1 = row.law.depth_t0 + step.dt * row.law.normal.dot(row.velocity);
    const Vec3 path = normal_of_path(contact.sliding_normal, row.law.normal, row.velocity);
    row.law.normal = (contact.sliding_normal + path).normalized();
    row.law.depth_t0 = depth_t1 - step.dt * row.law.normal.dot(row.velocity);
}
//! [push_between_paths]

}  // namespace

void update_row(const World& world, const Contact& contact, const StepLaw& step, PairRow& row)
{
    row.law.normal = contact.normal_t0.isZero(0) ? normal_of(pair_step(world, contact), step.centre)
                                                 : contact_geometry(world, contact, step.centre).normal;
    const Vec3 start = relative_position(world, contact, &Body::positions_t0),
               end = relative_position(world, contact, &Body::positions_t1);
    row.law.depth_t0 = row.law.normal.dot(start) - contact.gap - contact.spring.rest_offset;
    row.velocity = (end - start) / step.dt;
    row.acting = contact.impulse + contact.friction;
    if (!contact.sliding_normal.isZero(0))
        push_between_paths(contact, step, row);
    const Vec3 running = running_of_surfaces(world, contact);
    if (!running.isZero(0))  // along the surface: friction feels it, and the depth does not
        row.velocity += running - row.law.normal.dot(running) * row.law.normal;
    if (const std::optional<Mat3> grain = grain_of(world, contact, row.law.normal)) {
        row.law.grain = *grain;
        row.law.has_grain = true;
    }
}

}  // namespace enduring
