#include "exercises/04_friction/2_grain.hpp"
#include "exercises/not_implemented_yet.hpp"

namespace enduring {

bool holds(const Grain& grain, const Vec2& wanted, double normal_impulse)
{
    not_implemented_yet("4.2");
}

Vec2 sliding_impulse(const Grain& grain, const Vec2& velocity, double normal_impulse)
{
    not_implemented_yet("4.2");
}

Vec2 stopping_place(const Grain& grain, Vec2 velocity, double gravity, double dt)
{
    not_implemented_yet("4.2");
}

}  // namespace enduring
