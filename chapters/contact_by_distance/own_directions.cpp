#include "chapters/contact_by_distance/own_directions.hpp"

#include "chapters/08_speculative_contacts/feature_cones.hpp"
#include "chapters/contact_by_distance/distance_parts.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>

namespace enduring {

bool keeps_shape(const Body& body)
{
    return body.is_static() || dynamic_cast<const RigidBody*>(&body) != nullptr;
}

bool is_ridge(const Body& body, int edge)
{
    return fold_at_edge(surface_at(body, 0), edge) < -distance_parts.least_fold;
}

OwnDirections::OwnDirections(const Body& body)
    : of_vertex(static_cast<std::size_t>(body.surface().vertex_count()), true)
{
    if (!keeps_shape(body))
        return;
    for (std::size_t v = 0; v < of_vertex.size(); ++v) {
        const auto edges = body.surface().edges_around_vertex(static_cast<int>(v));
        of_vertex[v] = std::any_of(edges.begin(), edges.end(),
                                   [&](int edge) { return is_ridge(body, edge); });
    }
}

}  // namespace enduring
