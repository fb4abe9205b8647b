#include "chapters/08_contact_by_distance/own_directions.hpp"

#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/feature_cones.hpp"
#include "common/simulation/deforming_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>

namespace enduring {

bool keeps_shape(const Body& body)
{
    const bool is_given = body.is_static() && dynamic_cast<const DeformingBody*>(&body) == nullptr;
    return is_given || dynamic_cast<const RigidBody*>(&body) != nullptr;
}

bool is_ridge(const Body& body, int edge)
{
    return fold_at_edge(surface_at(body, 0), edge) < -distance_parts.least_fold;
}

bool has_own_directions(const Body& body, int vertex)
{
    const auto edges = body.surface().edges_around_vertex(vertex);
    const auto is_border = [&](int edge) { return body.surface().faces_at_edge(edge)[1] < 0; };
    return !keeps_shape(body) || edges.empty() || std::any_of(edges.begin(), edges.end(), is_border) ||
           std::count_if(edges.begin(), edges.end(), [&](int edge) { return is_ridge(body, edge); }) > 2;
}

}  // namespace enduring
