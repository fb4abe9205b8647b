#include "chapters/08_speculative_contacts/sliding_normal.hpp"

#include "chapters/06_redefinition/pair_projection.hpp"
#include "chapters/08_speculative_contacts/search_parts.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

void Ground::look_at(const SurfaceStep& a, int vertex, const SurfaceStep& b, int face)
{
    const SurfaceMoment surface{b, 0};
    const auto foot = foot_on_face({a, 0}, vertex, surface, face);
    if (!foot || std::abs(foot->depth) >= distance ||
        *std::min_element(foot->weights.begin(), foot->weights.end()) < 0)
        return;
    distance = std::abs(foot->depth);
    normal = surface.face_normal(face).stableNormalized();
}

//! [sliding_normal]
Vec3 sliding_normal(const Vec3& start, const Vec3& end, const Vec3& motion)
{
    const Vec3 before = 2 * start - end;
    const double at_start = start.dot(motion), at_before = before.dot(motion);
    const double part = at_start / (at_start - at_before);  // not a number where the surface is flat
    if (start.dot(end) < search_parts.hand_on || !(std::abs(part) <= 1))
        return Vec3::Zero();
    return (start + std::max(0.0, part) * (before - start)).normalized();
}
//! [sliding_normal]

Vec3 motion_without_gravity(const World& world, const Contact& contact, double dt)
{
    Vec3 motion = Vec3::Zero();
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const Body& body = *world.bodies[body_index(contact, i)];
        const auto n = static_cast<std::size_t>(i);
        const auto vertex = static_cast<std::size_t>(contact.vertices[n]);
        const Vec3 fall = dt * dt * body.acceleration(contact.vertices[n], world.gravity);
        motion += contact.weights[n] * (body.positions_t1()[vertex] - body.positions_t0()[vertex] - fall);
    }
    return motion;
}

}  // namespace enduring
