#include "chapters/08_speculative_contacts/feature_cones.hpp"
#include "chapters/08_speculative_contacts/meeting.hpp"

namespace enduring {
namespace {

bool is_on_edge(double weight, double tolerance) { return weight >= -tolerance && weight <= 1 + tolerance; }

/// Two edges, and what is asked of them at a moment.
struct TwoEdges {
    const SurfaceStep &a, &b;
    int edge_a, edge_b;
    bool known;

    PairVertices vertices_at(double tau) const
    {
        const auto [a0, a1] = a.edge(edge_a);
        const auto [b0, b1] = b.edge(edge_b);
        const SurfaceMoment at_a{a, tau}, at_b{b, tau};
        return {at_a.position(a0), at_a.position(a1), at_b.position(b0), at_b.position(b1)};
    }
    /// As the cross product of the edges has it; none for parallel ones.
    std::optional<EdgeFeet> feet_at(double tau) const
    {
        return feet_of_edges(vertices_at(tau), 1, search_parts.edge_sine);
    }
    bool in_cones(const Vec3& normal, double tau) const
    {
        const auto in_cone = [&](const SurfaceStep& surface, int edge, const Vec3& direction) {
            return in_cone_of_edge({surface, tau}, edge, direction, search_parts.cone_sine,
                                   search_parts.least_fold);
        };
        return in_cone(b, edge_b, normal) && in_cone(a, edge_a, -normal);
    }
    /// Whether they are nearest to each other at a moment when they are near.
    std::optional<Meeting> near_at(double tau) const
    {
        const auto feet = feet_at(tau);
        if (!feet)
            return std::nullopt;
        const double sign = in_cones(feet->normal, tau) ? 1 : in_cones(-feet->normal, tau) ? -1 : 0;
        if (sign == 0)
            return std::nullopt;
        const double tolerance = known ? search_parts.hysteresis : 0;
        if (!is_on_edge(feet->s, tolerance) || !is_on_edge(feet->t, tolerance))
            return std::nullopt;
        return Meeting{tau, 0, 0, sign, {1 - feet->s, feet->s, feet->t - 1, -feet->t}};
    }
    /// Where an edge passes the other.
    /// @param sign  of the normal that makes their depth positive at the start
    std::optional<Meeting> crossing(double sign) const
    {
        const auto entry = find_entry(edge_edge_step(a, edge_a, b, edge_b), [&](const Crossing& crossing) {
            const auto feet = feet_at(crossing.time);
            return feet && crossing.orientation == sign && in_cones(sign * feet->normal, crossing.time);
        });
        if (!entry)
            return std::nullopt;
        return Meeting{entry->time, 0, 0, entry->orientation, entry->weights};
    }
};

}  // namespace

//! [find_edge_meeting]
std::optional<Meeting> find_edge_meeting(const SurfaceStep& a, int edge_a, const SurfaceStep& b, int edge_b,
                                         const Reach& reach, bool known)
{
    const TwoEdges pair{a, b, edge_a, edge_b, known};
    const auto feet_t0 = pair.feet_at(0), feet_t1 = pair.feet_at(1);
    if (!feet_t0 || !feet_t1)
        return std::nullopt;
    if (const auto meeting = pair.near_at(0);
        meeting && near_at_start(meeting->orientation * feet_t0->depth, reach, known))
        return meeting;
    const double sign = feet_t0->depth > 0 ? 1 : -1, depth_t1 = sign * feet_t1->depth;  // with this normal
    if (const auto meeting = pair.crossing(sign))
        return meeting;
    if (depth_t1 > 0 && depth_t1 <= reach.margin)
        if (const auto meeting = pair.near_at(1); meeting && meeting->orientation == sign)
            return meeting;
    return std::nullopt;
}
//! [find_edge_meeting]

}  // namespace enduring
