#include "exercises/08_contact_by_distance/2_nearest_feature.hpp"

#include <algorithm>

namespace enduring {

MeshFeature feature_at(const Face& face, const std::array<double, 3>& weights)
{
    MeshFeature feature;
    for (std::size_t corner = 0; corner < 3; ++corner)
        if (weights[corner] != 0)
            feature.push_back(face[corner]);
    std::sort(feature.begin(), feature.end());
    return feature;
}

bool is_locally_nearest(const SurfaceMesh& mesh, const MeshFeature& feature, const Vec3& p, double distance)
{
    const std::vector<int> around = faces_at(mesh, feature);
    return std::none_of(around.begin(), around.end(),
                        [&](int face) { return closest_on_face(mesh, face, p).distance < distance - 1e-9; });
}

std::vector<PointPair> near_pairs(const SurfaceMesh& mesh, const Vec3& p, double distance)
{
    std::vector<PointPair> pairs;
    for (int face = 0; face < static_cast<int>(mesh.faces.size()); ++face) {
        const ClosestOnTriangle closest = closest_on_face(mesh, face, p);
        const MeshFeature feature = feature_at(mesh.faces[static_cast<std::size_t>(face)], closest.weights);
        const bool known = std::any_of(pairs.begin(), pairs.end(), [&](const PointPair& pair) {
            return (pair.nearest - closest.point).norm() < 1e-9;
        });
        if (!known && closest.distance <= distance && is_locally_nearest(mesh, feature, p, closest.distance))
            pairs.push_back(
                {feature, closest.point, (p - closest.point) / closest.distance, closest.distance});
    }
    return pairs;
}

int ridges_at(const SurfaceMesh& mesh, int vertex)
{
    int ridges = 0;
    for (const int f : faces_at(mesh, {vertex})) {
        const Face& face = mesh.faces[static_cast<std::size_t>(f)];
        const auto at = std::find(face.begin(), face.end(), vertex) - face.begin();
        const int next = face[static_cast<std::size_t>(at + 1) % 3];  // so each edge comes once
        for (const int other : faces_at(mesh, {std::min(vertex, next), std::max(vertex, next)}))
            for (const int corner : mesh.faces[static_cast<std::size_t>(other)]) {
                const Vec3 path = position(mesh, corner) - position(mesh, vertex);
                if (normal_of_face(mesh, f).dot(path) < -1e-4 * path.norm())
                    ++ridges;
            }
    }
    return ridges;
}

bool has_directions(const SurfaceMesh& mesh, int vertex) { return ridges_at(mesh, vertex) > 2; }

}  // namespace enduring
