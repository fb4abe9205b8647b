#include "exercises/08_contact_by_distance/2_nearest_feature.hpp"

#include <map>
#include <set>

namespace enduring {

MeshFeature feature_at(const Face& face, const std::array<double, 3>& weights)
{
    std::set<int> corners;
    for (std::size_t i = 0; i < 3; ++i)
        if (weights[i] > 0)
            corners.insert(face[i]);
    return {corners.begin(), corners.end()};
}

bool is_locally_nearest(const SurfaceMesh& mesh, const MeshFeature& feature, const Vec3& p, double distance)
{
    double least = distance;
    for (const int face : faces_at(mesh, feature))
        least = std::min(least, closest_on_face(mesh, face, p).distance);
    return least >= distance - 1e-9;
}

std::vector<PointPair> near_pairs(const SurfaceMesh& mesh, const Vec3& p, double distance)
{
    std::vector<PointPair> found;
    for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
        const ClosestOnTriangle place = closest_on_face(mesh, f, p);
        const MeshFeature feature = feature_at(mesh.faces[static_cast<std::size_t>(f)], place.weights);
        bool keep = place.distance <= distance && is_locally_nearest(mesh, feature, p, place.distance);
        for (const PointPair& before : found)
            keep = keep && (before.nearest - place.point).squaredNorm() >= 1e-18;
        if (keep)
            found.push_back({feature, place.point, (p - place.point).normalized(), place.distance});
    }
    return found;
}

int ridges_at(const SurfaceMesh& mesh, int vertex)
{
    std::map<int, std::vector<int>> faces_of_edge;  // by its other end
    for (const int f : faces_at(mesh, {vertex}))
        for (const int other : mesh.faces[static_cast<std::size_t>(f)])
            if (other != vertex)
                faces_of_edge[other].push_back(f);
    int ridges = 0;
    for (const auto& [end, faces] : faces_of_edge)
        for (const int third : mesh.faces[static_cast<std::size_t>(faces[1])]) {
            const Vec3 path = position(mesh, third) - position(mesh, vertex);
            if (third != vertex && third != end)
                ridges += path.normalized().dot(normal_of_face(mesh, faces[0])) < -1e-4 ? 1 : 0;
        }
    return ridges;
}

bool has_directions(const SurfaceMesh& mesh, int vertex) { return ridges_at(mesh, vertex) >= 3; }

}  // namespace enduring
