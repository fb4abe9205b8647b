#include "chapters/08_speculative_contacts/feature_cones.hpp"

#include <algorithm>

namespace enduring {
namespace {

/// Whether one of some faces looks that way; -1 stands for none. Where a surface is flat, it tells its outer side from
/// its inner one.
bool any_faces(const SurfaceMoment& surface, std::span<const int> faces, const Vec3& direction)
{
    return std::any_of(faces.begin(), faces.end(),
                       [&](int face) { return face >= 0 && surface.face_normal(face).dot(direction) > 0; });
}

/// From an edge into one of its faces, at right angles to the edge, unit length; zero for a face without area.
Vec3 into_face(const SurfaceMoment& surface, const Edge& edge, int face)
{
    const Vec3 corner = surface.position(edge[0]);
    const Vec3 along = (surface.position(edge[1]) - corner).stableNormalized();
    for (const int vertex : surface.step.face(face))
        if (vertex != edge[0] && vertex != edge[1]) {
            const Vec3 path = surface.position(vertex) - corner;
            return (path - along.dot(path) * along).stableNormalized();
        }
    return Vec3::Zero();
}

}  // namespace

double fold_at_edge(const SurfaceMoment& surface, int edge)
{
    const auto [face, other] = surface.step.topology.faces_at_edge(edge);
    if (other < 0)
        return -1;
    return surface.face_normal(face).stableNormalized().dot(
        into_face(surface, surface.step.edge(edge), other));
}

//! [cone_tests]
bool is_foremost(const SurfaceMoment& surface, int vertex, const Vec3& direction, double sine)
{
    const Vec3 corner = surface.position(vertex);
    for (const int index : surface.step.topology.edges_around_vertex(vertex)) {
        const auto [p, q] = surface.step.edge(index);
        const Vec3 path = surface.position(p == vertex ? q : p) - corner;
        if (path.dot(direction) > sine * path.norm())
            return false;
    }
    return true;
}

bool in_cone_of_vertex(const SurfaceMoment& surface, int vertex, const Vec3& direction, double sine)
{
    const auto faces = surface.step.topology.faces_around_vertex(vertex);
    return (faces.empty() || any_faces(surface, faces, direction)) &&
           is_foremost(surface, vertex, direction, sine);
}

bool in_cone_of_edge(const SurfaceMoment& surface, int edge, const Vec3& direction, double sine,
                     double least_fold)
{
    const auto& faces = surface.step.topology.faces_at_edge(edge);
    return any_faces(surface, faces, direction) &&
           std::none_of(faces.begin(), faces.end(),
                        [&](int face) {
                            return face >= 0 &&
                                   into_face(surface, surface.step.edge(edge), face).dot(direction) > sine;
                        }) &&
           fold_at_edge(surface, edge) < -least_fold;
}
//! [cone_tests]

}  // namespace enduring
