#pragma once

#include "chapters/09_deep_contacts/overlaps.hpp"
#include "common/simulation/step.hpp"

#include <functional>
#include <map>
#include <tuple>
#include <vector>

namespace enduring {

/// Finds the vertices that lie in another body without a pair, and gives them one: with the face through
/// which the separation direction of their overlap leads; and the edges that cross on its border without one. It needs no
/// history. Between bodies with closed surfaces only.
///
/// The trees are shaped once, so it belongs to one world.
class InsidePairs {
public:
    /// Finds where bodies overlap at the start of the step.
    void trace(const World& world);
    /// A pair for each vertex in a traced overlap that has none in the list, and for edges that cross on its border.
    void append_pairs(const World& world, Contacts& contacts);
    /// Both.
    void append_missing(const World& world, Contacts& contacts)
    {
        trace(world);
        append_pairs(world, contacts);
    }

    /// How much of the separation direction of its overlap lies along a pair's normal, in [0, 1]; 1 where no vertex
    /// of it is in an overlap. Asked after append_pairs().
    double part_along_direction(const World& world, const Contact& contact) const;

private:
    /// What two bodies, a < b, have in common.
    struct BodyOverlaps {
        int a, b;
        std::vector<Overlap> overlaps;
    };

    void fit_trees(const World& world);

    void note_direction(int body_a, const std::vector<int>& vertices, int body_b, const Vec3& direction);

    using Key = std::tuple<int, int, int>;     ///< body_a, vertex, body_b
    std::map<Key, Vec3> direction_of_vertex_;  ///< of this step
    std::vector<BodyOverlaps> overlaps_;       ///< of this step
    std::vector<const Body*> bodies_;          ///< whose trees these are
    std::vector<FaceTree> trees_;
};

/// Lets the rest offset of each spring fade: a tenth in each step, as chapter 7 has it, but no faster than its body
/// may be let out. So a spring with an initial overlap brings no energy, and throws nothing.
/// @param keep  part of its rest offset that a spring keeps in a step at least
/// @param most  by how much a pair's rest offset may fade in the step [m], not negative
void fade_rest_offset(Contacts& contacts, double keep, const std::function<double(const Contact&)>& most);

}  // namespace enduring
