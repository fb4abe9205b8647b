#pragma once

#include "common/geometry/vector.hpp"

#include <cstddef>
#include <vector>

namespace enduring {

/// What surfaces do beside Coulomb's friction. Each number is 0 where there is nothing of the kind.
struct SurfaceLaws {
    double viscous = 0;  ///< of a film between them: friction over normal force and speed [s/m]
    double rolling = 0;  ///< the largest torque against rolling, over the normal force [m]
    double patch =
        0;  ///< radius of the round patch on which each pair rubs when it spins about its normal [m]

    bool any() const { return viscous > 0 || rolling > 0 || patch > 0; }
};

struct FrictionCoefficients {
    double mu_s = 0, mu_d = 0;  ///< of a pair that holds, and of one that slips
    SurfaceLaws laws{};
};

/// A surface that rubs otherwise along one direction than at right angles to it, as brushed metal or a blade
/// does.
struct Grain {
    /// unit length, in the coordinates of the body's pose (body_pose.hpp), or of the world; zero for a
    /// surface without a grain
    Vec3 direction = Vec3::Zero();
    double across = 1;  ///< the coefficients across it, over those along it

    bool any() const { return !direction.isZero(0); }
};

/// The coefficients of friction between each two materials of a scene, for those solvers that take them per
/// pair.
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
