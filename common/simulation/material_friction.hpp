#pragma once

#include <cstddef>
#include <vector>

namespace enduring {

struct FrictionCoefficients {
    double mu_s = 0, mu_d = 0;  ///< of a pair that holds, and of one that slips
};

/// The coefficients of friction between each two materials of a scene, for those solvers that take them per pair.
struct MaterialFriction {
    static constexpr int none = -1;  ///< the material of a body that names none

    int materials = 0;  ///< how many there are; none means that all pairs have the same coefficients
    /// (materials + 1) squared: for each material, `none` first, those with each material, `none` first
    std::vector<FrictionCoefficients> between{};

    /// Where those of two materials stand in `between`.
    int place_of(int one, int other) const { return (one + 1) * (materials + 1) + other + 1; }
    const FrictionCoefficients& of(int one, int other) const
    {
        return between[static_cast<std::size_t>(place_of(one, other))];
    }
};

}  // namespace enduring
