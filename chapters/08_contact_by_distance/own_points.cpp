#include "chapters/08_contact_by_distance/own_points.hpp"

#include "chapters/06_redefinition/pair_projection.hpp"
#include "chapters/08_contact_by_distance/own_directions.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <vector>

namespace enduring {
namespace {

void put_edges(const PairVertices& x, Contact& contact)
{
    if (const auto feet = feet_of_edges(x, contact.orientation))
        contact.weights = {1 - feet->s, feet->s, feet->t - 1, -feet->t};
}

/// Where on an edge a point has the other one straight above itself, from its first end on; one half for an
/// edge along the normal.
double along_edge(const Vec3& p, const Vec3& from, const Vec3& to, const Vec3& normal)
{
    const Vec3 edge = to - from, across = edge - normal.dot(edge) * normal;
    const double squared = across.squaredNorm();
    return squared > 0 ? across.dot(p - from) / squared : 0.5;
}

}  // namespace

void put_on_own_surfaces(const World& world, double tau, Contact& contact)
{
    const bool both_soft = !keeps_shape(*world.bodies[static_cast<std::size_t>(contact.body_a)]) &&
                           !keeps_shape(*world.bodies[static_cast<std::size_t>(contact.body_b)]);
    PairVertices x;
    for (std::size_t i = 0; i < 4; ++i)
        x[i] = contact_vertex(world, contact, static_cast<int>(i), both_soft ? 0 : tau);
    if (contact.kind == ContactKind::edge_edge)
        return put_edges(x, contact);
    std::vector<std::size_t> on;  // the corners of B's feature
    for (std::size_t i = 1; i < 4; ++i)
        if (contact.weights[i] != 0)
            on.push_back(i);
    if (on.size() == 2) {
        const double t = along_edge(x[0], x[on[0]], x[on[1]], contact.normal_t0);
        contact.weights[on[0]] = t - 1;
        contact.weights[on[1]] = -t;
    } else if (on.size() == 3)
        if (const auto foot = foot_on_triangle(x[0], x[1], x[2], x[3]))
            for (std::size_t i = 0; i < 3; ++i)
                contact.weights[i + 1] = -foot->weights[i];
}

}  // namespace enduring
