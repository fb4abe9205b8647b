#pragma once

#include "chapters/05_categorisation/category.hpp"

#include <string>
#include <vector>

namespace enduring::chapter05 {

/// Two boxes that overlap, body 0 A and body 1 B, and one pair of features that is the same in all
/// arrangements: a vertex of A's flat top, and an upright face of B that it lies a little behind.
struct Arrangement {
    std::string name;
    World world;
    Contact contact;     ///< of kind vertex_face
    Vec3 way_out;        ///< shortest translation of A that parts the boxes [m]
    bool truly_regular;  ///< the pair's normal lies closer than 45 degrees to the way out
};

/// Thesis figure 6.9: a box stands in the ground a little; a plate is stuck
/// in a wall; a box has sunk deep into the ground.
std::vector<Arrangement> arrangements();

/// All that the rule reads of a pair: the vertex, the face, and the faces around the vertex [m].
std::vector<Vec3> local_positions(const Arrangement& arrangement);

}  // namespace enduring::chapter05
