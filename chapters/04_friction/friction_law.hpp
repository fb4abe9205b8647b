#pragma once

#include "chapters/04_friction/tangent_plane.hpp"
#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

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
    /// speed of p against its anchor where the pair lets go [m/s]; 0 while it holds
    double slip = 0;
};

/// omega(x) = 1 - exp(-k_w x), thesis (5.24): 0 at rest, 1 in motion,
/// and omega(x) / x -> k_w where x -> 0 (5.25).
/// @param weighting  k_w [s/m]
/// @param speed      x [m/s], not negative
inline double slip_weight(double weighting, double speed) { return -std::expm1(-weighting * speed); }

/// Yamane and Nakamura's model as the thesis prints it, (5.22) to (5.24): a spring and a damper where they
/// stay within mu_s, dynamic friction where they would not.
/// @param dt  [s]
/// @return    |impulse| <= mu_s |I_n|
FrictionImpulse yamane_nakamura(const SlidingPair& pair, const YamaneNakamura& friction, double dt);

/// The spring and the damper between an anchor and its point, for one step of backward Euler: the pair's
/// impulse and its slip at the end of the step obey  J = -dt (k (s + dt u) + d u).
struct Anchor {
    double spring;  ///< k [N/m]
    double damper;  ///< d [N s/m]
    Vec2 stretch;   ///< s, at the start of the step [m]
    double dt;      ///< [s]

    /// slip per impulse that the damper allows [1/kg]
    double yielding() const { return 1 / (dt * (dt * spring + damper)); }
    /// u of J [m/s]
    Vec2 held_velocity(const Vec2& impulse) const { return -yielding() * (impulse + dt * spring * stretch); }
};

/// Spring as asked for, but no stiffer than brings a pair's share of its bodies back to the anchor in one
/// step; damper by its ratio to the critical one of spring and share.
/// @param inverse_mass  of the share [1/kg], positive
Anchor anchor_of(const MassSplitting& friction, double inverse_mass, const Vec2& stretch, double dt);

/// One better guess at a pair's friction: the change that would bring its slip to what the anchor allows if
/// nobody else changed, cut to what the pair can hold.
///
/// Beyond mu_s it slips, and the faster it does the nearer its limit is to mu_d: mu_s +
/// (mu_d - mu_s) omega(slip). A pair that only creeps still carries mu_s, so the first
/// corner of a body to give way does not take the others along.
///
/// @param impulse         the guess so far [N s]
/// @param velocity        slip with that guess in effect [m/s]
/// @param inverse_mass    a bound on the slip that a unit impulse changes, shared [1/kg], positive
/// @param normal_impulse  |I_n| of this step [N s]
/// @return                |impulse| <= mu |I_n|
FrictionImpulse better_impulse(const Vec2& impulse, const Vec2& velocity, double inverse_mass,
                               double normal_impulse, const Anchor& anchor, const MassSplitting& friction);

/// How far p may lie from its anchor when the pair has let go [m]: as far as the pull that is left can hold,
/// and the less the faster it slips.
/// @param slip     [m/s]
/// @param impulse  length of the friction impulse [N s]
double stretch_after_slip(double slip, double impulse, const MassSplitting& friction, double dt);

}  // namespace enduring
