#pragma once

#include "common/simulation/scene.hpp"
#include "tangent_plane.hpp"

#include <cmath>

namespace enduring {

/// What the model knows of one pair in one step, in coordinates of its tangent plane.
struct SlidingPair {
    Vec2 stretch;           ///< p - p_ref at the start of the step [m]
    Vec2 velocity;          ///< of p against q, as predicted without friction [m/s]
    double normal_impulse;  ///< |I_n| of this step [N s], positive
};

/// What a model answers.
struct FrictionImpulse {
    Vec2 impulse = Vec2::Zero();  ///< on p [N s]
    double slip = 0;              ///< speed of p against its anchor where the pair lets go [m/s]; 0 while it holds
};

/// omega(x) = 1 - exp(-k_w x), thesis (5.24): 0 at rest, 1 in motion, and omega(x) / x -> k_w where x -> 0 (5.25).
/// @param weighting  k_w [s/m]
/// @param speed      x [m/s], not negative
inline double slip_weight(double weighting, double speed) { return -std::expm1(-weighting * speed); }

/// Yamane and Nakamura's model as the thesis prints it, (5.22) to (5.24): a spring and a damper where they stay within
/// mu_s, dynamic friction where they would not.
/// @param dt  [s]
/// @return    |impulse| <= mu_s |I_n|
FrictionImpulse yamane_nakamura(const SlidingPair& pair, const FrictionParameters& friction, double dt);

}  // namespace enduring
