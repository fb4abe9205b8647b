#include "common/simulation/contact_geometry.hpp"

#include "common/simulation/surface_axes.hpp"

namespace enduring {
namespace {

ContactGeometry plane_geometry(const Plane& plane, const Vec3& p, double gap)
{
    const double height = plane.normal.dot(p - plane.point);
    return {p, p - height * plane.normal, plane.normal, height - gap};
}

/// Unit vector, or zero when the features are parallel or degenerate and no direction is better than another.
Vec3 unit_or_zero(const Vec3& v)
{
    const double length = v.norm();
    return length > 0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

Vec3 normal_direction(const Contact& contact, const std::array<Vec3, 4>& x)
{
    if (contact.kind == ContactKind::vertex_face)
        return (x[2] - x[1]).cross(x[3] - x[1]);
    return contact.orientation * (x[1] - x[0]).cross(x[3] - x[2]);
}

/// A vertex against a plane; any two sides will do that span it and whose product is its normal.
PairStep plane_step(const Body& body, std::size_t vertex, const Plane& plane)
{
    const Vec3 side_1 = plane.normal.unitOrthogonal(), side_2 = plane.normal.cross(side_1);
    return {{side_1, side_2, body.positions_t0()[vertex] - plane.point},
            {side_1, side_2, body.positions_t1()[vertex] - plane.point},
            plane.normal};
}

PairInstant instant(const Contact& contact, const PairVertices& x)
{
    return contact.kind == ContactKind::vertex_face ? vertex_face_instant(x)
                                                    : edge_edge_instant(x, contact.orientation);
}

//! [turned_normal]
/// The normal of the start, turned with the pair's features.
Vec3 turned_normal(const Contact& contact, const PairVertices& t0, const PairVertices& x)
{
    const PairInstant start = instant(contact, t0), now = instant(contact, x);
    const auto from = surface_axes(start.side_1, start.side_2), to = surface_axes(now.side_1, now.side_2);
    return from && to ? Vec3(*to * (from->transpose() * contact.normal_t0)) : contact.normal_t0;
}
//! [turned_normal]

Vec3 normal_at(const World& world, const Contact& contact, const PairVertices& x, double tau)
{
    if (contact.normal_t0.isZero(0))
        return unit_or_zero(normal_direction(contact, x));
    if (tau == 0)
        return contact.normal_t0;
    PairVertices t0;
    for (std::size_t i = 0; i < 4; ++i)
        t0[i] = contact_vertex(world, contact, static_cast<int>(i), 0);
    return turned_normal(contact, t0, x);
}

}  // namespace

Vec3 contact_vertex(const World& world, const Contact& contact, int i, double tau)
{
    return body_of_vertex(world, contact, i).position(contact.vertices[i], tau);
}

ContactGeometry contact_geometry(const World& world, const Contact& contact, double tau)
{
    if (contact.on_plane())
        return plane_geometry(world.planes[contact.body_b], contact_vertex(world, contact, 0, tau),
                              contact.gap);

    std::array<Vec3, 4> x;
    ContactGeometry geometry;
    for (std::size_t i = 0; i < 4; ++i) {
        x[i] = contact_vertex(world, contact, static_cast<int>(i), tau);
        if (static_cast<int>(i) < contact.vertices_of_a())
            geometry.p += contact.weights[i] * x[i];
        else
            geometry.q -= contact.weights[i] * x[i];
    }
    geometry.normal = normal_at(world, contact, x, tau);
    geometry.depth = geometry.normal.dot(geometry.p - geometry.q) - contact.gap;
    return geometry;
}

PairStep pair_step(const World& world, const Contact& contact)
{
    if (contact.on_plane())
        return plane_step(body_of_vertex(world, contact, 0), static_cast<std::size_t>(contact.vertices[0]),
                          world.planes[contact.body_b]);
    PairVertices t0, t1;
    for (std::size_t i = 0; i < 4; ++i) {
        const Body& body = body_of_vertex(world, contact, static_cast<int>(i));
        const auto vertex = static_cast<std::size_t>(contact.vertices[i]);
        t0[i] = body.positions_t0()[vertex];
        t1[i] = body.positions_t1()[vertex];
    }
    PairStep step{instant(contact, t0), instant(contact, t1)};
    if (!contact.normal_t0.isZero(0))
        step.plane_normal = contact.normal_t0;
    return step;
}

double pair_stiffness(const World& world, const Contact& contact, double of_all_pairs)
{
    if (!contact.on_plane())
        return of_all_pairs;
    return world.planes[contact.body_b].stiffness.value_or(of_all_pairs);
}

namespace {

/// Those of A and B.
std::pair<int, int> materials_of(const World& world, const Contact& contact)
{
    const auto b = static_cast<std::size_t>(contact.body_b);
    return {world.bodies[static_cast<std::size_t>(contact.body_a)]->material(),
            contact.on_plane() ? world.planes[b].material : world.bodies[b]->material()};
}

}  // namespace

const FrictionCoefficients& pair_friction(const World& world, const Contact& contact,
                                          const FrictionCoefficients& of_all_pairs)
{
    if (world.friction.materials == 0)
        return of_all_pairs;
    const auto [one, other] = materials_of(world, contact);
    if (one == MaterialFriction::none && other == MaterialFriction::none)
        return of_all_pairs;
    return world.friction.of(one, other);
}

double pair_restitution(const World& world, const Contact& contact)
{
    const auto [one, other] = materials_of(world, contact);
    return world.restitution.of(one, other);
}

Vec3 running_of_surfaces(const World& world, const Contact& contact)
{
    const Vec3& of_a = world.bodies[static_cast<std::size_t>(contact.body_a)]->surface_velocity();
    if (contact.on_plane())
        return of_a;
    return of_a - world.bodies[static_cast<std::size_t>(contact.body_b)]->surface_velocity();
}

const std::string& name_of_a(const World& world, const Contact& contact)
{
    return world.bodies[contact.body_a]->name();
}

const std::string& name_of_b(const World& world, const Contact& contact)
{
    const std::size_t b = static_cast<std::size_t>(contact.body_b);
    return contact.on_plane() ? world.planes[b].name : world.bodies[b]->name();
}

}  // namespace enduring
