#pragma once

#include "common/simulation/material_friction.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace enduring {

/// The coefficient of restitution between each two materials of a scene, in [0, 1], for those solvers that
/// let bodies bounce. The place `none` has that of bodies without a material, so a world without materials
/// has one entry.
struct MaterialRestitution {
    int materials = 0;
    /// (materials + 1) squared: for each material, MaterialFriction::none first, that with each material,
    /// `none` first
    std::vector<double> between{0.0};

    std::size_t place_of(int one, int other) const
    {
        return static_cast<std::size_t>(one + 1) * (static_cast<std::size_t>(materials) + 1) +
               static_cast<std::size_t>(other + 1);
    }
    double of(int one, int other) const { return between[place_of(one, other)]; }
    bool any() const
    {
        return std::any_of(between.begin(), between.end(), [](double one) { return one > 0; });
    }
};

}  // namespace enduring
