#pragma once

#include "chapters/07_implicit_contact/pair_memory.hpp"
#include "common/simulation/step.hpp"

#include <set>
#include <tuple>

namespace enduring {

/// Hysteresis for vertices at the rim of a face. The corners of equal boxes that stand edge on edge lie some
/// nanometres inside or outside each other, and change sides with every breath. A pair that pushes goes on
/// where its vertex has slipped over the rim by a hair: its spring keeps its load, where a new pair, once the
/// vertex is back, would begin slack.
class RimPairs {
public:
    /// Goes on with pairs that have just been resolved, since their vertex has left the body beside their face.
    /// @param before  the list as it was before that; now more pairs may stand behind its own
    /// @param choice  its wanted depth is how far from the face a foot on its plane may lie
    void keep(const World& world, const Contacts& before, const StiffnessChoice& choice, Contacts& contacts);

private:
    using Key = std::tuple<int, int, int>;  ///< body, vertex, other body

    std::set<Key> outside_;  ///< vertices that are outside, though their pair goes on
};

/// The same for pairs of edges, whose feet may lie beyond an end: those that pushed before are not held there.
/// @param before  the list as it was before edges were held
/// @param choice  its wanted depth is how far from an end a foot may lie
void push_beyond_ends(const World& world, const Contacts& before, const StiffnessChoice& choice,
                      Contacts& contacts);

}  // namespace enduring
