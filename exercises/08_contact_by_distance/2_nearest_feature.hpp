#pragma once

#include "common/geometry/closest_points.hpp"
#include "common/geometry/meshes.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace enduring {

/// A face, an edge or a vertex of a mesh: its three, two or one vertices, ascending.
using MeshFeature = std::vector<int>;

/// A point and a place on a surface that is the nearest one in its neighbourhood.
struct PointPair {
    MeshFeature feature;
    Vec3 nearest;     ///< the place [m]
    Vec3 normal;      ///< from there to the point, unit length
    double distance;  ///< [m]
};

/// Given: where a vertex is [m].
inline Vec3 position(const SurfaceMesh& mesh, int vertex)
{
    return mesh.vertices[static_cast<std::size_t>(vertex)];
}

/// Given: the normal of a face, out of the body, unit length.
inline Vec3 normal_of_face(const SurfaceMesh& mesh, int face)
{
    const auto [a, b, c] = mesh.faces[static_cast<std::size_t>(face)];
    return (position(mesh, b) - position(mesh, a))
        .cross(position(mesh, c) - position(mesh, a))
        .stableNormalized();
}

/// Given: the place of a face that is nearest to a point.
inline ClosestOnTriangle closest_on_face(const SurfaceMesh& mesh, int face, const Vec3& p)
{
    const auto [a, b, c] = mesh.faces[static_cast<std::size_t>(face)];
    return closest_on_triangle(p, position(mesh, a), position(mesh, b), position(mesh, c));
}

/// Given: the faces that have all vertices of a feature, ascending.
inline std::vector<int> faces_at(const SurfaceMesh& mesh, const MeshFeature& feature)
{
    std::vector<int> found;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        Face face = mesh.faces[f];
        std::sort(face.begin(), face.end());
        if (std::includes(face.begin(), face.end(), feature.begin(), feature.end()))
            found.push_back(static_cast<int>(f));
    }
    return found;
}

/// The feature of a face on which a place lies: the corners whose weights are not 0.
MeshFeature feature_at(const Face& face, const std::array<double, 3>& weights);

/// Whether no face at this feature comes nearer to p than a distance, by more than 1e-9 m.
bool is_locally_nearest(const SurfaceMesh& mesh, const MeshFeature& feature, const Vec3& p, double distance);

/// All places of a surface that are locally nearest to p, and no farther than a distance, in the order of the
/// faces on which they are found. Two places closer to each other than 1e-9 m are one: the first. The surface
/// does not hold p itself.
std::vector<PointPair> near_pairs(const SurfaceMesh& mesh, const Vec3& p, double distance);

/// How many edges at a vertex of a closed surface are ridges: the third corner of one of the two faces lies
/// behind the plane of the other face, by more than 1e-4 of its distance from the vertex.
int ridges_at(const SurfaceMesh& mesh, int vertex);

/// Whether a vertex of a closed surface has directions of its own. A vertex inside a flat side has none, and
/// one on a straight edge of a body has none either: what touches there, touches the side or the edge.
bool has_directions(const SurfaceMesh& mesh, int vertex);

}  // namespace enduring
