#pragma once

#include "common/simulation/step.hpp"

#include <span>
#include <vector>

namespace enduring {

//! [skin]
/// A body pushes from its skin outwards: springs act from the sum of two skins, so surfaces that are pressed together do not
/// meet. The contact surface of a body that keeps its shape lies inside its own by the skin, so at rest the skins touch where the
/// bodies themselves do. A plane has none: a body is pushed from its inset.
struct Skin {
    double thickness = 0;  ///< [m]
    double inset =
        0;  ///< by which the contact surface lies inside the body's own [m]; 0 for soft bodies and open sheets
};
//! [skin]

/// The skins of a world and the contact surfaces that go with them.
///
/// A skin is a part of the body's size; that of a body that stands or moves as given, of the smallest moving body's.
class Skins {
public:
    /// Gives each rigid body of a closed surface its contact surface, once; and again where the first step is taken back.
    void put(World& world);

    const Skin& of(int body) const { return skins_[static_cast<std::size_t>(body)]; }
    double between(int a, int b) const { return of(a).thickness + of(b).thickness; }
    /// The depth of a pair begins so far from the other surface [m].
    double gap(const Contact& contact) const;

private:
    std::vector<Skin> skins_;
    std::vector<std::vector<Vec3>> surfaces_;  ///< for contact, as placed(); empty where it is the body's own
    double time_ = 0;                          ///< at which they were put
};

/// A closed surface, moved inwards: each vertex so that the planes of its faces move by the distance (least squares). Where a face would
/// turn over, or the surface would meet itself on the way, its vertices move less.
/// @param distance  [m], positive
std::vector<Vec3> inset_surface(const SurfaceTopology& surface, std::span<const Vec3> positions,
                                double distance);

}  // namespace enduring
