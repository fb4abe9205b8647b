#pragma once

#include "chapters/08_contact_by_distance/near_pairs.hpp"
#include "chapters/09_deep_contacts/overlaps.hpp"
#include "common/simulation/step.hpp"

#include <map>
#include <tuple>
#include <vector>

namespace enduring {

/// Appends a pair for each two edges that cross on the border of an overlap and have none, where everything
/// lies at the start of the step: both feet lie on their edges, inside the other body, and the pair pushes
/// along the separation direction, give or take 45 degrees. The pairs endure.
///
/// Where the corners of two boxes lie beside each other there is no vertex in either box, and nothing but two
/// edges that hold them apart.
/// @param overlap  of body_a with body_b, places in World::bodies
void append_crossing_edges(const World& world, int body_a, int body_b, const Overlap& overlap,
                           Contacts& contacts);

/// Finds the vertices that lie in another body without a pair, and gives them one: with the face through
/// which the separation direction of their overlap leads; and the edges that cross on its border without one.
/// It needs no history. Between bodies with closed surfaces only.
///
/// The trees are shaped once, so it belongs to one world.
class InsidePairs {
public:
    /// Finds where bodies overlap at the start of the step.
    void trace(const World& world);
    /// The vertices that trace() found inside, those that touch the curve around them, the edges that end in
    /// these, and edges that pass through a face. They come out wherever their pairs push them. What is
    /// outside elsewhere has to stay there.
    /// @param touching  up to which distance two bodies touch [m]
    LeftOut left_out(const std::function<double(int body_a, int body_b)>& touching) const;
    /// A pair for each vertex in a traced overlap that has none in the list, and for edges that cross on its
    /// border.
    void append_pairs(const World& world, Contacts& contacts);

    /// How much of the separation direction of its overlap lies along a pair's normal, in [0, 1]; 1 where no
    /// vertex of it is in an overlap. Asked after append_pairs().
    double part_along_direction(const World& world, const Contact& contact) const;

private:
    /// What two bodies, a < b, have in common.
    struct BodyOverlaps {
        int a, b;
        std::vector<Overlap> overlaps;
    };

    void build(const World& world);
    std::vector<bool> fit_trees(const World& world);
    StillSurface still(int body) const;

    using Key = std::tuple<int, int, int>;     ///< body_a, vertex, body_b
    std::map<Key, Vec3> direction_of_vertex_;  ///< of this step
    std::vector<BodyOverlaps> traced_;         ///< those whose boxes overlap, ascending
    std::vector<const Body*> bodies_;          ///< whose trees these are
    std::vector<FaceTree> trees_;
    std::vector<bool> is_closed_;            ///< of each body's surface
    std::vector<std::vector<Vec3>> fitted_;  ///< where the vertices lay to which its tree is fitted
};

}  // namespace enduring
