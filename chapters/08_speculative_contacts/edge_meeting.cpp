#include "chapters/08_speculative_contacts/feature_cones.hpp"
#include "chapters/08_speculative_contacts/meeting.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

/// Whether a foot lies on an edge, or beyond an end from where the surface rises before it.
/// @param outward   normal of the pair, out of the edge's body
/// @param furthest  that it may lie beyond [m]
bool is_on_edge(const SurfaceMoment& surface, int edge, double weight, const Vec3& outward, double furthest,
                double tolerance)
{
    const double beyond = std::max(-weight, weight - 1);
    if (beyond <= tolerance)
        return true;
    const auto [p, q] = surface.step.edge(edge);
    return beyond * (surface.position(q) - surface.position(p)).norm() <= furthest &&
           !in_cone_of_vertex(surface, weight < 0 ? p : q, outward, search_parts.cone_sine);
}

/// Two edges, and what is asked of them at a moment.
struct TwoEdges {
    const SurfaceStep &a, &b;
    int edge_a, edge_b;
    const Reach& reach;
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
    /// How far the edges move against each other in the step [m].
    double path_length() const
    {
        const PairVertices t0 = vertices_at(0), t1 = vertices_at(1);
        double longest = 0;
        for (const std::size_t i : {0U, 1U})
            for (const std::size_t j : {2U, 3U})
                longest = std::max(longest, ((t1[i] - t0[i]) - (t1[j] - t0[j])).norm());
        return longest;
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
        const double furthest = reach.beyond_border(feet->depth, path_length());
        const double tolerance = known ? search_parts.hysteresis : 0;
        if (!is_on_edge({a, tau}, edge_a, feet->s, -sign * feet->normal, furthest, tolerance) ||
            !is_on_edge({b, tau}, edge_b, feet->t, sign * feet->normal, furthest, tolerance))
            return std::nullopt;
        return Meeting{tau, 0, 0, sign, {1 - feet->s, feet->s, feet->t - 1, -feet->t}};
    }
    /// Where an edge passes the other; or, if it slides along a third one into a corner, the other's line beyond its end.
    /// @param sign  of the normal that makes their depth positive at the start
    std::optional<Meeting> crossing(double sign, bool ends_inside) const
    {
        const auto enters = [&](const Crossing& crossing) {
            const auto feet = feet_at(crossing.time);
            return feet && crossing.orientation == sign && in_cones(sign * feet->normal, crossing.time);
        };
        if (const auto entry = find_entry(edge_edge_step(a, edge_a, b, edge_b), enters))
            return Meeting{entry->time, 0, 0, entry->orientation, entry->weights};
        if (!ends_inside)
            return std::nullopt;
        const PairStep pair{edge_edge_instant(vertices_at(0), sign), edge_edge_instant(vertices_at(1), sign)};
        for (const Interval& below : penetration_intervals(penetration_depth(contact_normal(pair), pair)))
            if (auto meeting = near_at(below.from); meeting && meeting->orientation == sign)
                return meeting;
        return std::nullopt;
    }
};

}  // namespace

//! [find_edge_meeting]
std::optional<Meeting> find_edge_meeting(const SurfaceStep& a, int edge_a, const SurfaceStep& b, int edge_b,
                                         const Reach& reach, bool known)
{
    const TwoEdges pair{a, b, edge_a, edge_b, reach, known};
    const auto feet_t0 = pair.feet_at(0), feet_t1 = pair.feet_at(1);
    if (!feet_t0 || !feet_t1)
        return std::nullopt;
    if (known || std::abs(feet_t0->depth) <= std::max(reach.margin, reach.inside))
        if (const auto meeting = pair.near_at(0);
            meeting && near_at_start(meeting->orientation * feet_t0->depth, reach, known))
            return meeting;
    const double sign = feet_t0->depth > 0 ? 1 : -1;  // with this normal it is positive
    return pair.crossing(sign, sign * feet_t1->depth < 0);
}
//! [find_edge_meeting]

}  // namespace enduring
