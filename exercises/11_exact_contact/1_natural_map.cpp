#include "exercises/11_exact_contact/1_natural_map.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

Vec3 nearest_point(const Vec3& impulse, double mu)
{
    not_implemented_yet("11.1");
}

Vec3 map_of_contact(const Vec3& impulse, const Vec3& velocity, double mu)
{
    not_implemented_yet("11.1");
}

Vec3 impulse_on_block(const Vec3& free_velocity, double mass, double mu)
{
    not_implemented_yet("11.1");
}

int passes_needed(double h, double part)
{
    not_implemented_yet("11.1");
}

}  // namespace enduring
