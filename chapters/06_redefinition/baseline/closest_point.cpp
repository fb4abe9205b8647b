#include "chapters/06_redefinition/baseline/closest_point.hpp"

#include <cmath>

namespace enduring {
namespace {

const Vec3& at(std::span<const Vec3> positions, int vertex) { return positions[vertex]; }

const Face& face_of(const SurfaceTopology& surface, int face) { return surface.faces()[face]; }

Vec3 unit_normal(const SurfaceTopology& surface, std::span<const Vec3> positions, int face)
{
    const auto [a, b, c] = face_of(surface, face);
    return (at(positions, b) - at(positions, a))
        .cross(at(positions, c) - at(positions, a))
        .stableNormalized();
}

double angle_at(const SurfaceTopology& surface, std::span<const Vec3> positions, int face, int vertex)
{
    Face corners = face_of(surface, face);
    while (corners[0] != vertex)
        corners = {corners[1], corners[2], corners[0]};
    const Vec3 one = at(positions, corners[1]) - at(positions, vertex),
               other = at(positions, corners[2]) - at(positions, vertex);
    return std::atan2(one.cross(other).norm(), one.dot(other));
}

bool on_border(const SurfaceTopology& surface, int edge) { return surface.faces_at_edge(edge)[1] < 0; }

Vec3 edge_pseudonormal(const SurfaceTopology& surface, std::span<const Vec3> positions, int edge)
{
    if (on_border(surface, edge))
        return Vec3::Zero();
    const auto [one, other] = surface.faces_at_edge(edge);
    return unit_normal(surface, positions, one) + unit_normal(surface, positions, other);
}

Vec3 vertex_pseudonormal(const SurfaceTopology& surface, std::span<const Vec3> positions, int vertex)
{
    for (const int edge : surface.edges_around_vertex(vertex))
        if (on_border(surface, edge))
            return Vec3::Zero();
    Vec3 sum = Vec3::Zero();
    for (const int face : surface.faces_around_vertex(vertex))
        sum += angle_at(surface, positions, face, vertex) * unit_normal(surface, positions, face);
    return sum;
}

}  // namespace

//! [closest_weights]
FaceWeights closest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 ab = b - a, ac = c - a;
    const double ab_a = ab.dot(p - a), ac_a = ac.dot(p - a);
    if (ab_a <= 0 && ac_a <= 0)
        return {1, 0, 0};
    const double ab_b = ab.dot(p - b), ac_b = ac.dot(p - b);
    if (ab_b >= 0 && ac_b <= ab_b)
        return {0, 1, 0};
    const double ab_c = ab.dot(p - c), ac_c = ac.dot(p - c);
    if (ac_c >= 0 && ab_c <= ac_c)
        return {0, 0, 1};

    // Areas of the triangles that p makes with the edges, times the triangle's own: negative beyond an edge.
    const double area_c = ab_a * ac_b - ab_b * ac_a, area_b = ab_c * ac_a - ab_a * ac_c,
                 area_a = ab_b * ac_c - ab_c * ac_b;
    if (area_c <= 0 && ab_a >= 0 && ab_b <= 0) {
        const double t = ab_a / (ab_a - ab_b);
        return {1 - t, t, 0};
    }
    if (area_b <= 0 && ac_a >= 0 && ac_c <= 0) {
        const double t = ac_a / (ac_a - ac_c);
        return {1 - t, 0, t};
    }
    const double along_bc = ac_b - ab_b, back_along_bc = ab_c - ac_c;
    if (area_a <= 0 && along_bc >= 0 && back_along_bc >= 0) {
        const double t = along_bc / (along_bc + back_along_bc);
        return {0, 1 - t, t};
    }
    const double sum = area_a + area_b + area_c;
    return {area_a / sum, area_b / sum, area_c / sum};
}
//! [closest_weights]

//! [closest_point]
ClosestPoint closest_point(const FaceTree& tree, const SurfaceTopology& surface,
                           std::span<const Vec3> positions, const Vec3& p, double within)
{
    ClosestPoint best;
    best.squared_distance = within * within;
    tree.visit_near(p, best.squared_distance, [&](int face) {
        const auto [a, b, c] = face_of(surface, face);
        const FaceWeights w = closest_weights(p, at(positions, a), at(positions, b), at(positions, c));
        const Vec3 point = w[0] * at(positions, a) + w[1] * at(positions, b) + w[2] * at(positions, c);
        const double squared_distance = (p - point).squaredNorm();
        if (squared_distance < best.squared_distance)
            best = {face, w, point, squared_distance};
    });
    return best;
}
//! [closest_point]

Vec3 pseudonormal(const SurfaceTopology& surface, std::span<const Vec3> positions,
                  const ClosestPoint& closest)
{
    const Face& corners = face_of(surface, closest.face);
    for (std::size_t i = 0; i < 3; ++i)
        if (closest.weights[i] == 1)
            return vertex_pseudonormal(surface, positions, corners[i]);
    for (std::size_t i = 0; i < 3; ++i)  // the edge that begins at corner i lies opposite corner i + 2
        if (closest.weights[(i + 2) % 3] == 0)
            return edge_pseudonormal(surface, positions, surface.edges_of_face(closest.face)[i]);
    return unit_normal(surface, positions, closest.face);
}

}  // namespace enduring
