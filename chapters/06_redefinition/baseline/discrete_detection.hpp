#pragma once

#include "chapters/06_redefinition/baseline/closest_point.hpp"
#include "common/simulation/contact.hpp"
#include "common/simulation/step.hpp"

#include <limits>

namespace enduring {

/// Discrete detection: the vertices that lie inside another body at the end of the
/// predicted step, each with the closest point of its surface (thesis 5.1). It looks at one
/// moment and at vertices alone, so it never sees two edges that cross between their ends,
/// nor what came in and left again by another side within a step.
///
/// A vertex that is far outside cannot be inside soon: the distance to a surface changes
/// by no more than the vertex and the surface move. So each vertex keeps how far it may
/// still go, and is looked at only when that is used up.
class DiscreteDetection {
public:
    /// Brings the pairs of vertices and faces up to date with positions_t1: those not yet answered in this
    /// step get the face and weights of their closest point now, or end; vertices that have come in are
    /// appended. A pair keeps everything else.
    void update_inside_vertices(const World& world, Contacts& contacts);

private:
    /// The vertices of body `a` against the surface of body `b`.
    struct Side {
        int a, b;
        std::vector<double> clearance;  ///< of each vertex: what is left of its distance to the surface [m]
        std::vector<int> pair;          ///< of each vertex: its place in the list of contacts, or -1
    };

    void build(const World& world);
    void refit(const World& world);
    void use_up_clearances();
    void look_at(const World& world, Side& side, Contacts& contacts) const;

    std::vector<const Body*> bodies_;  ///< whose trees these are
    std::vector<FaceTree> trees_;
    /// where each body's vertices were when they were last looked at [m]
    std::vector<std::vector<Vec3>> last_;
    std::vector<std::vector<double>> moved_;  ///< how far each has gone since [m]
    std::vector<Side> sides_;
};

}  // namespace enduring
