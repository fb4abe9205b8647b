#pragma once

#include "common/scenes/scene.hpp"

#include <optional>
#include <string>

namespace enduring {

/// The contact that bears the shortest step, of all that the bodies of a scene could make.
struct StiffestContact {
    std::string a, b;    ///< two bodies, or a body and a plane
    int pairs;           ///< n: the fewest with which they can stand on each other
    double stiffness;    ///< n k [N/m]
    double mass;         ///< what the n pairs move, reduced [kg]
    double stable_step;  ///< [s]
    bool of_plane;       ///< the stiffness is the plane's own
};

/// Looks for it before a run. How many pairs two bodies will have nobody knows, so each contact is taken at
/// its most harmless: a body that moves as one stands on the corners of its smallest flat side, and each node
/// of a soft one that answers alone has one pair, where the node is heaviest. What is unstable even so is
/// unstable in any case; what is not may be all the same, with more pairs or when it rocks.
/// @return  nothing where no two bodies can meet
std::optional<StiffestContact> stiffest_contact(const World& world, const ContactParameters& contact);

/// Vertices on the smallest flat side of a surface: three of a sphere's, four of a box' with one cell.
/// @param positions  of its vertices [m]
int corners_of_smallest_side(const SurfaceTopology& surface, std::span<const Vec3> positions);

}  // namespace enduring
