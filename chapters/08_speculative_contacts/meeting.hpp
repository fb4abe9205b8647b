#pragma once

#include "chapters/03_penalty_impulses/crossing.hpp"
#include "chapters/06_redefinition/pair_projection.hpp"
#include "chapters/08_speculative_contacts/search_parts.hpp"

#include <optional>

namespace enduring {

/// Two features that may push each other in a step, and how they lie at the moment that tells: at its start where they
/// are near or inside each other then, or else when one passes the other.
struct Meeting {
    double tau = 0;  ///< of that moment, in [0, 1]
    /// of two meetings of a vertex that with the smaller cost counts first: at the start its distance from the face [m],
    /// in a crossing the moment
    double cost = 0;
    /// whether a vertex passes the face within the step, also where it is near at the start; or ends near it
    bool passes = false;
    double orientation = 1;
    PairWeights weights{};
};

/// How far the two points of a pair move against each other in a step [m].
/// @param t0, t1  its four vertices at both ends of the step
inline double path_length(const PairVertices& t0, const PairVertices& t1, const PairWeights& weights)
{
    Vec3 path = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i)
        path += weights[i] * (t1[i] - t0[i]);
    return path.norm();
}

/// Whether a pair that is so deep at the start may be near or inside then.
/// @param slid  how much deeper it may be, since its features slide [m]
inline bool near_at_start(double depth_t0, const Reach& reach, double slid = 0)
{
    return -reach.inside - slid <= depth_t0 && depth_t0 <= reach.margin;
}

/// Whether and how a vertex of A may come to push a face of B in this step.
/// @param known  it has a pair with this face since the last step
std::optional<Meeting> find_meeting(const SurfaceStep& a, int vertex, const SurfaceStep& b, int face,
                                    const Reach& reach, bool known);

/// The same for two edges.
std::optional<Meeting> find_edge_meeting(const SurfaceStep& a, int edge_a, const SurfaceStep& b, int edge_b,
                                         const Reach& reach, bool known);

}  // namespace enduring
