#include "chapters/08_speculative_contacts/feature_cones.hpp"
#include "chapters/08_speculative_contacts/meeting.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

//! [beyond_end]
/// Whether a foot is an edge's. Beyond its end another feature takes over; not where a concave edge ends in the same vertex,
/// which has no cone then: there the edge goes on, as a face does below its neighbour at a concave edge.
/// @param weight    of the edge's second end
/// @param furthest  that it may go on [m]
bool is_on_edge(const SurfaceMoment& surface, int edge, double weight, double furthest, double tolerance)
{
    const double beyond = std::max(-weight, weight - 1);
    if (beyond <= tolerance)
        return true;
    const auto [from, to] = surface.step.edge(edge);
    if (beyond * (surface.position(to) - surface.position(from)).norm() > furthest)
        return false;
    const auto edges = surface.step.topology.edges_around_vertex(weight < 0 ? from : to);
    return std::any_of(edges.begin(), edges.end(),
                       [&](int other) { return fold_at_edge(surface, other) > search_parts.least_fold; });
}
//! [beyond_end]

/// Two edges, and what is asked of them at a moment. What costs least is asked first: most pairs end there.
struct TwoEdges {
    const SurfaceStep &a, &b;
    int edge_a, edge_b;
    const Reach& reach;
    bool known;
    PairVertices t0{a.start(a.edge(edge_a)[0]), a.start(a.edge(edge_a)[1]), b.start(b.edge(edge_b)[0]),
                    b.start(b.edge(edge_b)[1])};
    PairVertices t1{a.end(a.edge(edge_a)[0]), a.end(a.edge(edge_a)[1]), b.end(b.edge(edge_b)[0]),
                    b.end(b.edge(edge_b)[1])};

    /// As the cross product of the edges has it; none for parallel ones.
    static std::optional<EdgeFeet> feet_of(const PairVertices& x)
    {
        return feet_of_edges(x, 1, search_parts.edge_sine);
    }
    std::optional<EdgeFeet> feet_at(double tau) const
    {
        return feet_of({lerp(t0[0], t1[0], tau), lerp(t0[1], t1[1], tau), lerp(t0[2], t1[2], tau),
                        lerp(t0[3], t1[3], tau)});
    }
    /// A pair that is known stays where elements have bent so far that an edge is not convex any more: in the next step it may be.
    bool in_cones(const Vec3& normal, double tau) const
    {
        const double least_fold = known ? -search_parts.cone_sine : search_parts.least_fold;
        const auto in_cone = [&](const SurfaceStep& surface, int edge, const Vec3& direction) {
            return in_cone_of_edge({surface, tau}, edge, direction, search_parts.cone_sine, least_fold);
        };
        return in_cone(b, edge_b, normal) && in_cone(a, edge_a, -normal);
    }
    static PairWeights weights_of(const EdgeFeet& feet) { return {1 - feet.s, feet.s, feet.t - 1, -feet.t}; }
    /// Whether they are nearest to each other at a moment when they are near.
    std::optional<Meeting> near_at(double tau, const EdgeFeet& feet) const
    {
        const PairWeights weights = weights_of(feet);
        const double furthest = reach.beyond_border(feet.depth, path_length(t0, t1, weights)),
                     tolerance = known ? search_parts.hysteresis : 0;
        if (!is_on_edge({a, tau}, edge_a, feet.s, furthest, tolerance) ||
            !is_on_edge({b, tau}, edge_b, feet.t, furthest, tolerance))
            return std::nullopt;
        const double sign = in_cones(feet.normal, tau) ? 1 : in_cones(-feet.normal, tau) ? -1 : 0;
        if (sign == 0)
            return std::nullopt;
        return Meeting{tau, 0, 0, sign, weights};
    }
    /// Where an edge passes the other, or the line on which it goes on.
    /// @param sign  of the normal that makes the depth of their lines positive at the start
    std::optional<Meeting> crossing(double sign) const
    {
        const EdgeEdgeStep step{t0[0], t0[1], t0[2], t0[3], t1[0], t1[1], t1[2], t1[3]};
        if (const CertifiedAnswer touch = certified_answer(step);
            !touch.time && touch.stage == QueryStage::height)
            return std::nullopt;  // the lines do not pass each other
        const auto entry = find_entry(step, [&](const Crossing& crossing) {
            const auto feet = feet_at(crossing.time);
            return feet && in_cones(crossing.orientation * feet->normal, crossing.time);
        });
        if (entry)
            return Meeting{entry->time, 0, 0, entry->orientation, entry->weights};
        const PairStep pair{edge_edge_instant(t0, sign), edge_edge_instant(t1, sign)};
        for (const Interval& below : penetration_intervals(penetration_depth(contact_normal(pair), pair)))
            if (const auto feet = feet_at(below.from))
                if (const auto meeting = near_at(below.from, *feet); meeting && meeting->orientation == sign)
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
    const auto feet_t0 = pair.feet_of(pair.t0), feet_t1 = pair.feet_of(pair.t1);
    if (!feet_t0 || !feet_t1)
        return std::nullopt;
    const double slid = search_parts.slid * path_length(pair.t0, pair.t1, TwoEdges::weights_of(*feet_t0));
    if (std::abs(feet_t0->depth) <= std::max(reach.margin, reach.inside + slid))
        if (const auto meeting = pair.near_at(0, *feet_t0);
            meeting && near_at_start(meeting->orientation * feet_t0->depth, reach, slid))
            return meeting;
    const double sign = feet_t0->depth > 0 ? 1 : -1, depth_t1 = sign * feet_t1->depth;  // with this normal
    if (const auto meeting = pair.crossing(sign))
        return meeting;
    if (depth_t1 > 0 && depth_t1 <= reach.margin)
        if (const auto meeting = pair.near_at(1, *feet_t1); meeting && meeting->orientation == sign)
            return meeting;
    return std::nullopt;
}
//! [find_edge_meeting]

}  // namespace enduring
