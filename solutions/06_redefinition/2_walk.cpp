#include "exercises/06_redefinition/2_walk.hpp"

#include <algorithm>
#include <stdexcept>

namespace enduring {

std::array<double, 3> foot_weights(const SurfaceMoment& surface, int face, const Vec3& point)
{
    const auto [f0, f1, f2] = surface.step.face(face);
    const Vec3 corner = surface.position(f0), side_1 = surface.position(f1) - corner,
               side_2 = surface.position(f2) - corner;
    const Vec3 normal = side_1.cross(side_2), offset = point - corner;
    const double squared_length = normal.squaredNorm();
    if (!(squared_length > 0))
        throw std::domain_error("a face without area");
    const double w1 = offset.cross(side_2).dot(normal) / squared_length;
    const double w2 = side_1.cross(offset).dot(normal) / squared_length;
    return {1 - w1 - w2, w1, w2};
}

std::optional<Walk> walk_to_foot(const SurfaceMoment& surface, int face, const Vec3& point, int most)
{
    const SurfaceTopology& topology = surface.step.topology;
    for (int crossed = 0; crossed <= most; ++crossed) {
        const std::array<double, 3> weights = foot_weights(surface, face, point);
        const auto least =
            static_cast<std::size_t>(std::min_element(weights.begin(), weights.end()) - weights.begin());
        if (weights[least] >= -1e-12)
            return Walk{face, weights, crossed};
        // Edge i runs from corner i to corner i + 1, so edge i + 1 lies opposite corner i.
        const int edge = topology.edges_of_face(face)[(least + 1) % 3];
        const auto [one, other] = topology.faces_at_edge(edge);
        face = one == face ? other : one;
        if (face < 0)
            return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace enduring
