#include "chapters/03_penalty_impulses/penalty_impulse.hpp"

#include "chapters/03_penalty_impulses/penetration.hpp"
#include "exercises/not_implemented_yet.hpp"

namespace enduring {

Vec3 discrete_impulse(const PairInstant& end, double k, double dt)
{
    not_implemented_yet("3.1");
}

Vec3 integral_of_product(const Bernstein<double, 3>& depth, const Bernstein<Vec3, 2>& normal)
{
    not_implemented_yet("3.1");
}

Vec3 continuous_impulse(const PairStep& step, double start, double k, double dt)
{
    not_implemented_yet("3.1");
}

}  // namespace enduring
