#include "chapters/08_contact_by_distance/feature_cones.hpp"

#include <algorithm>

namespace enduring {
namespace {

/// Whether one of some faces looks that way; -1 stands for none. Where a surface is flat, it tells its outer
/// side from its inner one.
bool any_faces(const SurfaceMoment& surface, std::span<const int> faces, const Vec3& direction)
{
    return std::any_of(faces.begin(), faces.end(),
                       [&](int face) { return face >= 0 && surface.face_normal(face).dot(direction) > 0; });
}

/// From an edge into each of its two faces, at right angles to the edge, unit length; zero for none, and for
/// a face without area.
std::array<Vec3, 2> into_faces(const SurfaceMoment& surface, int edge)
{
    const Edge& ends = surface.step.edge(edge);
    const Vec3 corner = surface.position(ends[0]),
               along = (surface.position(ends[1]) - corner).stableNormalized();
    const auto into = [&](int face) -> Vec3 {
        if (face < 0)
            return Vec3::Zero();
        const Face& corners = surface.step.face(face);
        const int vertex = *std::find_if(corners.begin(), corners.end(),
                                         [&](int one) { return one != ends[0] && one != ends[1]; });
        const Vec3 path = surface.position(vertex) - corner;
        return (path - along.dot(path) * along).stableNormalized();
    };
    const auto [face, other] = surface.step.topology.faces_at_edge(edge);
    return {into(face), into(other)};
}

/// As fold_at_edge(), from what leads into the second face.
double fold(const SurfaceMoment& surface, int edge, const Vec3& into_other)
{
    const auto [face, other] = surface.step.topology.faces_at_edge(edge);
    return other < 0 ? -1 : surface.face_normal(face).stableNormalized().dot(into_other);
}

}  // namespace

double fold_at_edge(const SurfaceMoment& surface, int edge)
{
    return fold(surface, edge, into_faces(surface, edge)[1]);
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

bool in_cone_of_edge(const SurfaceMoment& surface, int edge, const Vec3& direction, double sine,
                     double least_fold)
{
    const auto& faces = surface.step.topology.faces_at_edge(edge);
    if (faces[0] >= 0 && !any_faces(surface, faces, direction))  // a wire has no inner side
        return false;
    const auto [into, into_other] = into_faces(surface, edge);
    return into.dot(direction) <= sine && into_other.dot(direction) <= sine &&
           fold(surface, edge, into_other) < -least_fold;
}
//! [cone_tests]

}  // namespace enduring
