#pragma once

#include "common/geometry/meshes.hpp"

namespace enduring::solvers {

/// A link of a bicycle chain, as one closed surface: two plates with a waist and what joins them around both
/// pins. The pins are parallel to y, and the link lies along x. Holes and pins have twelve corners.
struct ChainLink {
    static constexpr double pitch = 0.0127;                     ///< between its pins [m]
    static constexpr double play_aside = 35e-6, play = 0.0002;  ///< of a pin and along it, at least [m]
    static constexpr double outer_half_height = 0.0038;         ///< of the plates outside [m]

    /// Two plates with two pins.
    static SurfaceMesh outer();
    /// Two plates between those, with two bushings around the pins.
    static SurfaceMesh inner();
};

}  // namespace enduring::solvers
