#include "exercises/11_exact_contact/2_multiplier_step.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

Vec3 impulse_of_spring(const BlockOnSpring& block, const Vec3& begin)
{
    not_implemented_yet("11.2");
}

Vec3 next_begin(const BlockOnSpring& block, const Vec3& impulse)
{
    not_implemented_yet("11.2");
}

Vec3 impulse_after(const BlockOnSpring& block, int passes)
{
    not_implemented_yet("11.2");
}

Vec3 predicted_impulse(const BlockOnSpring& block, const Vec3& exact, int passes)
{
    not_implemented_yet("11.2");
}

}  // namespace enduring
