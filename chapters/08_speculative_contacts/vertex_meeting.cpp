#include "chapters/08_speculative_contacts/feature_cones.hpp"
#include "chapters/08_speculative_contacts/meeting.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

//! [beyond_rim]
/// How far a foot lies beyond its face [m]. A face goes on below its neighbour at a concave edge, as far as a vertex may
/// have come by its depth and its motion; at all other edges it ends.
/// @param furthest  that it may go on [m]
/// @return          0 for a foot on the face, none for one that is not the face's
std::optional<double> beyond_rim(const SurfaceMoment& surface, int face, const TriangleFoot& foot,
                                 double furthest, double tolerance)
{
    const Face& corners = surface.step.face(face);
    double beyond = 0;
    for (std::size_t i = 0; i < 3; ++i) {  // the edge opposite of corner i
        const Vec3 p = surface.position(corners[(i + 1) % 3]), q = surface.position(corners[(i + 2) % 3]);
        const Vec3 along = (q - p).stableNormalized(), across = surface.position(corners[i]) - p;
        const double height = (across - along.dot(across) * along).norm();
        const double distance = -foot.weights[i] * height;
        if (distance <= tolerance * (q - p).norm())
            continue;
        const int edge = surface.step.topology.edges_of_face(face)[(i + 1) % 3];
        if (distance > furthest || fold_at_edge(surface, edge) < search_parts.least_fold)
            return std::nullopt;
        beyond = std::max(beyond, distance);
    }
    return beyond;
}
//! [beyond_rim]

/// A vertex and a face, and what is asked of them at a moment.
struct VertexAndFace {
    const SurfaceStep &a, &b;
    int vertex, face;
    const Reach& reach;
    bool known;
    VertexFaceStep step = vertex_face_step(a, vertex, b, face);
    PairVertices t0{step.v_t0, step.f0_t0, step.f1_t0, step.f2_t0};
    PairVertices t1{step.v_t1, step.f0_t1, step.f1_t1, step.f2_t1};

    std::optional<TriangleFoot> foot_at(double tau) const
    {
        return foot_on_face({a, tau}, vertex, {b, tau}, face);
    }
    bool in_cone(double tau) const
    {
        const SurfaceMoment side{b, tau};
        const Vec3 direction = -side.face_normal(face).stableNormalized();
        return reach.faces_tell ? in_cone_of_vertex({a, tau}, vertex, direction, search_parts.cone_sine)
                                : is_foremost({a, tau}, vertex, direction, search_parts.cone_sine);
    }
    /// Whether they are nearest to each other at a moment when they are near.
    std::optional<Meeting> near_at(double tau, const TriangleFoot& foot) const
    {
        const auto [w0, w1, w2] = foot.weights;
        const PairWeights weights{1, -w0, -w1, -w2};
        const double furthest = reach.beyond_border(foot.depth, path_length(t0, t1, weights));
        const auto beyond = beyond_rim({b, tau}, face, foot, furthest, known ? search_parts.hysteresis : 0);
        if (!beyond || !in_cone(tau))
            return std::nullopt;
        return Meeting{tau, tau > 0 ? tau : std::abs(foot.depth) + *beyond, 0, 1, weights};
    }
    /// Where the vertex passes the face, though it may begin behind its plane, beyond an edge.
    std::optional<Meeting> crossing() const
    {
        const auto entry = find_entry(step, enters_face);
        if (!entry || !in_cone(entry->time))
            return std::nullopt;
        return Meeting{entry->time, entry->time, 0, 1, entry->weights};
    }
    /// Where the vertex slides down a wall into a corner, and passes the face's plane below that wall.
    std::optional<Meeting> crossing_below_a_wall() const
    {
        const PairStep pair{vertex_face_instant(t0), vertex_face_instant(t1)};
        for (const Interval& below : penetration_intervals(penetration_depth(contact_normal(pair), pair))) {
            const auto foot = foot_at(below.from);
            if (const auto meeting = foot ? near_at(below.from, *foot) : std::nullopt)
                return meeting;
        }
        return std::nullopt;
    }
};

}  // namespace

//! [find_meeting]
std::optional<Meeting> find_meeting(const SurfaceStep& a, int vertex, const SurfaceStep& b, int face,
                                    const Reach& reach, bool known)
{
    const VertexAndFace pair{a, b, vertex, face, reach, known};
    const auto foot_t0 = pair.foot_at(0), foot_t1 = pair.foot_at(1);
    if (!foot_t0 || !foot_t1)
        return std::nullopt;
    std::optional<Meeting> meeting;
    if (near_at_start(foot_t0->depth, reach))
        meeting = pair.near_at(0, *foot_t0);
    if (!meeting)
        meeting = pair.crossing();
    if (!meeting && foot_t0->depth > 0)
        meeting = pair.crossing_below_a_wall();
    if (!meeting && foot_t0->depth > 0 && foot_t1->depth > 0 && foot_t1->depth <= reach.margin)
        meeting = pair.near_at(1, *foot_t1);
    if (meeting)
        meeting->passes = meeting->tau > 0 ||
                          (foot_t0->depth > 0 && foot_t1->depth < 0 && pair.crossing().has_value());
    return meeting;
}
//! [find_meeting]

}  // namespace enduring
