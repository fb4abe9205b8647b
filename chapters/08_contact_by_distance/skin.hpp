#pragma once

#include "chapters/02_collision_detection/candidate_search.hpp"

#include <span>
#include <vector>

namespace enduring {

//! [skin]
/// Springs act where the bodies' own surfaces meet. A search for contact sees surfaces that lie inside of
/// them by a skin: so bodies that are pressed together overlap a little, and their surfaces for contact are
/// still apart, and tell a direction. At rest bodies touch as they are drawn.
///
/// A soft body bends, and a sheet has two sides: they have no other surface than their own. Against a closed
/// body that keeps its shape the other skin is enough. Where neither has one, they stay apart by both skins.
struct Skin {
    double thickness = 0;  ///< [m]
    double recess = 0;  ///< the farthest that a vertex lies inside, at a sharp corner more than the skin [m];
                        ///< 0 for soft bodies and sheets
};
//! [skin]

/// The skins of a world and the surfaces for contact that go with them.
///
/// A skin is a part of the body's size; that of a body that stands or moves as given, of the smallest moving
/// body's.
class Skins {
public:
    /// Gives each closed body that keeps its shape its surface for contact. A world is asked once.
    void put(World& world);
    /// Where neither body has an inner surface and they begin nearer than both skins, these shrink to half of
    /// the gap: nothing begins pressed. World::skins keeps what was decided, so a run that goes on takes it
    /// from there.
    /// @param search  after find_candidates with boxes that are larger by the skins
    void fit_gaps(World& world, const CandidateSearch& search);

    const Skin& of(int body) const { return skins_[static_cast<std::size_t>(body)]; }
    /// How far the surfaces for contact of two bodies can be from each other where the bodies touch [m].
    double distance(int a, int b) const;
    /// The distance at which the bodies' own surfaces count as touching [m].
    double gap(int a, int b) const;

private:
    std::vector<Skin> skins_;
};

/// A closed surface, moved inwards: each vertex so that the planes of its faces move by the distance (least
/// squares). Where a face would turn over, or the surface would meet itself on the way, its vertices move
/// less.
/// @param distance  [m], positive
std::vector<Vec3> inset_surface(const SurfaceTopology& surface, std::span<const Vec3> positions,
                                double distance);

}  // namespace enduring
