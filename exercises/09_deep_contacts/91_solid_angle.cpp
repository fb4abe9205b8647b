#include "exercises/09_deep_contacts/91_solid_angle.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>

namespace enduring {

double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point)
{
    not_implemented_yet("9.91");
}

double winding(const SurfaceMesh& mesh, const Vec3& point)
{
    not_implemented_yet("9.91");
}

std::vector<int> vertices_inside(const SurfaceMesh& one, const SurfaceMesh& other)
{
    not_implemented_yet("9.91");
}

std::vector<Vec3> middles_inside(const SurfaceMesh& one, const SurfaceMesh& other)
{
    not_implemented_yet("9.91");
}

}  // namespace enduring
