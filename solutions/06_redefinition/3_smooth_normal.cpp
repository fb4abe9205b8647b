#include "exercises/06_redefinition/3_smooth_normal.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

Vec3 vertex_normal(const SurfaceMoment& surface, int vertex)
{
    Vec3 sum = Vec3::Zero();
    for (const int face : surface.step.topology.faces_around_vertex(vertex)) {
        const Face& corners = surface.step.face(face);
        const std::size_t at = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
        const Vec3 here = surface.position(vertex);
        const Vec3 to_next = surface.position(corners[(at + 1) % 3]) - here,
                   to_last = surface.position(corners[(at + 2) % 3]) - here;
        const double angle = std::atan2(to_next.cross(to_last).norm(), to_next.dot(to_last));
        sum += angle * surface.face_normal(face).normalized();
    }
    return sum.normalized();
}

Vec3 smooth_normal(const SurfaceMoment& surface, int face, const std::array<double, 3>& weights)
{
    const Face& corners = surface.step.face(face);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        sum += weights[i] * vertex_normal(surface, corners[i]);
    return sum.normalized();
}

double largest_leap(std::span<const Vec3> normals)
{
    double largest = 0;
    for (std::size_t i = 1; i < normals.size(); ++i)
        largest = std::max(
            largest, std::atan2(normals[i].cross(normals[i - 1]).norm(), normals[i].dot(normals[i - 1])));
    return largest;
}

}  // namespace enduring
