#pragma once

#include "common/simulation/contact.hpp"
#include "common/simulation/step.hpp"
#include "shared_mass.hpp"
#include "yamane_nakamura.hpp"

namespace enduring {

/// The spring and the damper between an anchor and its point, for one step of backward Euler: the pair's impulse and its
/// slip at the end of the step obey  J = -dt (k (s + dt u) + d u).
struct Anchor {
    double spring;  ///< k [N/m]
    double damper;  ///< d [N s/m]
    Vec2 stretch;   ///< s, at the start of the step [m]
    double dt;      ///< [s]

    double yielding() const { return 1 / (dt * (dt * spring + damper)); }  ///< slip per impulse that the damper allows [1/kg]
    Vec2 held_velocity(const Vec2& impulse) const { return -yielding() * (impulse + dt * spring * stretch); }  ///< u of J [m/s]
};

/// Spring as asked for, but no stiffer than brings a pair's share of its bodies back to the anchor in one step; damper by
/// its ratio to the critical one of spring and share.
/// @param inverse_mass  of the share [1/kg], positive
Anchor anchor_of(const FrictionParameters& friction, double inverse_mass, const Vec2& stretch, double dt);

/// One better guess at a pair's friction: the change that would bring its slip to what the anchor allows if nobody else
/// changed, cut to what the pair can hold.
///
/// Beyond mu_s it slips, and the faster it does the nearer its limit is to mu_d: mu_s + (mu_d - mu_s) omega(slip). A pair
/// that only creeps still carries mu_s, so the first corner of a body to give way does not take the others along.
///
/// @param impulse         the guess so far [N s]
/// @param velocity        slip with that guess in effect [m/s]
/// @param inverse_mass    a bound on the slip that a unit impulse changes, shared [1/kg], positive
/// @param normal_impulse  |I_n| of this step [N s]
/// @return                |impulse| <= mu |I_n|
FrictionImpulse better_impulse(const Vec2& impulse, const Vec2& velocity, double inverse_mass, double normal_impulse,
                               const Anchor& anchor, const FrictionParameters& friction);

/// How far p may lie from its anchor when the pair has let go [m]: as far as the pull that is left can hold, and the less the
/// faster it slips.
/// @param slip     [m/s]
/// @param impulse  length of the friction impulse [N s]
double stretch_after_slip(double slip, double impulse, const FrictionParameters& friction, double dt);

/// The mended model for all pairs that push now: their springs first, then at most 30 rounds of better_impulse(), in each
/// of which every pair sees what all of them did before. Writes friction and slip; nothing is applied.
void rub_together(const World& world, Contacts& contacts, const FrictionParameters& friction, double dt);

}  // namespace enduring
