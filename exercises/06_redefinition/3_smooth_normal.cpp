#include "3_smooth_normal.hpp"

#include <algorithm>
#include <cmath>
#include "exercises/not_implemented_yet.hpp"

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
