#include "chapters/04_friction/friction_law.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {

FrictionImpulse yamane_nakamura(const SlidingPair& pair, const YamaneNakamura& friction, double dt)
{
    not_implemented_yet("4.1");
}

Anchor anchor_of(const MassSplitting& friction, double inverse_mass, const Vec2& stretch, double dt)
{
    not_implemented_yet("4.1");
}

double stretch_after_slip(double slip, double impulse, const MassSplitting& friction, double dt)
{
    not_implemented_yet("4.1");
}

FrictionImpulse better_impulse(const Vec2& impulse, const Vec2& velocity, double inverse_mass,
                               double normal_impulse, const Anchor& anchor, const MassSplitting& friction)
{
    not_implemented_yet("4.1");
}

}  // namespace enduring
