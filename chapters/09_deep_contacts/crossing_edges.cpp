#include "chapters/09_deep_contacts/inside_pairs.hpp"

#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/edge_pairs.hpp"

#include <algorithm>
#include <set>

namespace enduring {
namespace {

/// Two edges that cross are neighbours on the curve, but for the upright edges that it may pass at their
/// corners.
constexpr std::size_t max_ahead = 4;

//! [near_on_the_curve]
/// Edges of A with edges of B that a curve passes soon after each other.
std::set<FeaturePair> near_on_the_curve(const std::vector<Piercing>& curve)
{
    std::set<FeaturePair> near;
    for (std::size_t i = 0; i < curve.size(); ++i)
        for (std::size_t ahead = 1; ahead <= max_ahead; ++ahead) {
            const Piercing &one = curve[i], &next = curve[(i + ahead) % curve.size()];
            if (one.edge_of_a != next.edge_of_a)
                near.insert(one.edge_of_a ? FeaturePair{one.edge, next.edge}
                                          : FeaturePair{next.edge, one.edge});
        }
    return near;
}
//! [near_on_the_curve]

//! [pushes_out]
/// Lets a pair act at its feet, if these lie on the edges, inside the other body, and it pushes along the
/// separation direction.
bool pushes_out(const World& world, const Vec3& separation_direction, Contact& pair)
{
    const PairSurfaces surfaces(world, pair, 0);
    const PairVertices x = edge_vertices(surfaces, pair.feature_a, pair.feature_b);
    pair.orientation = (x[1] - x[0]).cross(x[3] - x[2]).dot(separation_direction) < 0 ? -1 : 1;
    const std::optional<EdgeFeet> feet = feet_of_edges(x, pair.orientation, smallest_edge_sine);
    if (!feet || feet->depth >= 0 || !feet->overlap(0) ||
        !is_within_45_degrees(feet->normal, separation_direction) ||
        is_hooked_edge_pair(surfaces.a, pair.feature_a, surfaces.b, pair.feature_b, feet->normal))
        return false;
    put_at(pair, *feet);
    return true;
}
//! [pushes_out]

}  // namespace

void append_crossing_edges(const World& world, int body_a, int body_b, const Overlap& overlap,
                           Contacts& contacts)
{
    const KnownPairs known(contacts);
    for (const std::vector<Piercing>& curve : overlap.curves)
        for (const auto& [edge_a, edge_b] : near_on_the_curve(curve)) {
            const auto [a0, a1] = world.bodies[body_a]->surface().edges()[edge_a];
            const auto [b0, b1] = world.bodies[body_b]->surface().edges()[edge_b];
            Contact pair{ContactKind::edge_edge, body_a, body_b, edge_a, edge_b, {a0, a1, b0, b1}};
            pair.category = ContactCategory::regular;
            if (!known.contain(pair) && pushes_out(world, overlap.separation_direction, pair))
                contacts.push_back(pair);
        }
}

}  // namespace enduring
