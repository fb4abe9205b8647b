#include "chapters/04_friction/surface_turn.hpp"

#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/surface_axes.hpp"

namespace enduring {
namespace {

/// p - q; on a plane, which stays, p alone.
Vec3 apart(const World& world, const Contact& contact, double tau)
{
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < contact.vertex_count(); ++i)
        sum += contact.weights[i] * contact_vertex(world, contact, i, tau);
    return sum;
}

}  // namespace

//! [surface_turn]
Mat3 surface_turn(const World& world, const Contact& contact)
{
    if (contact.on_plane())
        return Mat3::Identity();
    const auto [t0, t1, plane_normal] = pair_step(world, contact);
    const double start = contact.start;
    const auto from = surface_axes((1 - start) * t0.side_1 + start * t1.side_1,
                                   (1 - start) * t0.side_2 + start * t1.side_2);
    const auto to = surface_axes(t1.side_1, t1.side_2);
    return from && to ? Mat3(*to * from->transpose()) : Mat3::Identity();
}

Vec3 motion_on_surface(const World& world, const Contact& contact, const Mat3& turn)
{
    return apart(world, contact, 1) - turn * apart(world, contact, contact.start);
}
//! [surface_turn]

}  // namespace enduring
