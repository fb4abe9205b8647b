#include "exercises/06_redefinition/3_smooth_normal.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

Vec3 vertex_normal(const SurfaceMoment& surface, int vertex)
{
    not_implemented_yet("6.3");
}

Vec3 smooth_normal(const SurfaceMoment& surface, int face, const std::array<double, 3>& weights)
{
    not_implemented_yet("6.3");
}

double largest_leap(std::span<const Vec3> normals)
{
    not_implemented_yet("6.3");
}

}  // namespace enduring
