#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

/// Pairs with the other walls of a valley. Beside a vertex-face pair's face there may be one that looks back
/// at it across a concave edge. Outside means in front of both, so a vertex at the bottom needs a pair with
/// each.
///
/// Chapter 6 follows one pair for each vertex and body, its own one. The others are kept out of its sight
/// while it looks at the list, and stand in the list behind all own ones.
class ValleyPairs {
public:
    /// Takes them off the list.
    void set_aside(Contacts& contacts);

    /// Puts those back whose vertex still has its own pair.
    void put_back(Contacts& contacts);

    /// The same at the start of a step, when vertices may have gone on to other faces: what a spring holds
    /// stays with the wall that it pushes from, whichever pair is the vertex' own now.
    void follow(const World& world, Contacts& contacts);

private:
    /// A vertex' own pair, as it was, and those with further walls.
    struct Valley {
        Contact own;
        Contacts others;
    };
    std::vector<Valley> aside_;
};

/// Adds pairs with walls that a vertex can reach in this step. Each pushes from its wall's plane on.
void append_pairs_with_other_walls(const World& world, Contacts& contacts);

/// Drops the pairs of features that cannot touch what they are paired with. A concave edge that touched something
/// between its own ends would cut into it with both its faces; its ends are vertices, which have pairs of their own. A
/// flat one can be pushed along the normal of its side only. A vertex none of whose edges is convex would cut in with
/// all its faces, unless it is flat.
void drop_what_cannot_touch(const World& world, Contacts& contacts);

}  // namespace enduring
