#include "chapters/motivating_scenes/buried_vertex.hpp"

#include "common/geometry/triangle_distance.hpp"
#include "common/geometry/winding_number.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::motivating {
namespace {

bool is_pushed(const Contacts& contacts, int body_a, int vertex, int body_b)
{
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
        return contact.kind == ContactKind::vertex_face && !contact.held() && contact.body_a == body_a &&
               contact.feature_a == vertex && contact.body_b == body_b;
    });
}

}  // namespace

double depth_inside(const Body& body, const Vec3& point)
{
    double nearest = 1e300;
    for (const auto& [f0, f1, f2] : body.surface().faces()) {
        const auto corner = [&](int vertex) { return body.positions_t0()[vertex]; };
        const Vec3 a = corner(f0), b = corner(f1), c = corner(f2);
        nearest = std::min(nearest, distance_to_triangle(point, a, b, c));
    }
    return winding_number(body.surface().faces(), body.positions_t0(), point) > 0.5 ? nearest : 0;
}

double deepest_without_pair(const World& world, const Contacts& contacts, int body_a, int body_b)
{
    const Body &a = *world.bodies[body_a], &b = *world.bodies[body_b];
    double deepest = 0;
    for (int vertex = 0; vertex < a.surface().vertex_count(); ++vertex)
        if (!is_pushed(contacts, body_a, vertex, body_b))
            deepest = std::max(deepest, depth_inside(b, a.positions_t0()[vertex]));
    return deepest;
}

std::optional<double> longest_lever(const World& world, const Contacts& contacts)
{
    std::optional<double> longest;
    for (const Contact& contact : contacts) {
        if (contact.kind != ContactKind::vertex_face || contact.impulse.isZero())
            continue;
        const ContactGeometry at = contact_geometry(world, contact, 0);
        longest = std::max(longest.value_or(0), (at.p - at.q - at.depth * at.normal).norm());
    }
    return longest;
}

}  // namespace enduring::motivating
