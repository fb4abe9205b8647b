#include "common/geometry/offset_surface.hpp"

#include <Eigen/Geometry>

namespace enduring {

std::vector<Vec3> offset_surface(std::span<const Face> faces, std::span<const Vec3> positions,
                                 double distance)
{
    std::vector<Vec3> normals(positions.size(), Vec3::Zero()), result(positions.begin(), positions.end());
    for (const auto& [a, b, c] : faces)
        for (const int vertex : {a, b, c})
            normals[vertex] += (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    for (std::size_t vertex = 0; vertex < result.size(); ++vertex)
        result[vertex] += distance * normals[vertex].normalized();
    return result;
}

}  // namespace enduring
