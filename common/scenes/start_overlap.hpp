#pragma once

#include "common/scenes/scene.hpp"

#include <string>
#include <vector>

namespace enduring {

/// A body that begins inside another body, or deeper in a plane than all weight of the scene could press it.
struct StartOverlap {
    /// of two bodies the inner one moves; of two that move it has the deepest point
    std::string inner, outer;
    /// of the deepest point of either [m]: its distance to the surface of the other
    double depth;
    bool whole = false;     ///< no vertex of the inner one is outside
    bool in_plane = false;  ///< the outer one is a plane
    bool in_wall = false;   ///< the outer one is a room, and the inner one begins behind its walls
    bool closed = true;     ///< both surfaces are, so that there is a volume to separate from
};

/// All overlaps between bodies of which one moves at least, and between
/// moving bodies and planes. Touching is none.
///
/// Points are looked at that every surface has: its vertices, and the middles of its edges and
/// faces, as a box that stands in another of its size has all its corners on the surface of
/// that. An open surface has no inside: there a body overlaps if an edge of it passes through a
/// face, and the depth is that of the edge's end behind the face.
///
/// A static closed surface that faces inwards is a room. A body that moves overlaps with it as far as it is
/// not in the air of this or another room.
std::vector<StartOverlap> start_overlaps(const World& world, const ContactParameters& contact);

/// A body that meets itself and begins crossed with itself.
struct StartSelfOverlap {
    std::string body;
    int faces;  ///< that lie in another part of it, at least with a piece
};

/// A piece of a face is inside if the place just outside of it is; seven places of each face are looked at.
/// Of bodies that do not meet themselves nothing is said; what lies exactly face upon face counts as crossed.
std::vector<StartSelfOverlap> start_self_overlaps(const World& world);

}  // namespace enduring
