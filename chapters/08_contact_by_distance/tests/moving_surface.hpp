#pragma once

#include "chapters/05_categorisation/normal_span.hpp"
#include "chapters/06_redefinition/pair_projection.hpp"
#include "common/geometry/moved_mesh.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace enduring::chapter08 {

/// A surface whose vertices move on straight lines in a step.
struct MovingSurface {
    SurfaceTopology topology;
    std::vector<Vec3> t0, t1;

    explicit MovingSurface(const SurfaceMesh& mesh, const Vec3& path = Vec3::Zero())
        : topology(static_cast<int>(mesh.vertices.size()), mesh.faces), t0(mesh.vertices), t1(mesh.vertices)
    {
        for (Vec3& x : t1)
            x += path;
    }
    SurfaceStep step() const { return {topology, t0, t1}; }
    SurfaceMoment start() const { return {step(), 0}; }

    int edge_between(int p, int q) const
    {
        for (const int edge : topology.edges_around_vertex(p))
            if (const auto [v0, v1] = topology.edges()[static_cast<std::size_t>(edge)]; v0 == q || v1 == q)
                return edge;
        return -1;
    }
};

/// A vertex without a surface of its own.
inline SurfaceMesh particle(const Vec3& place) { return {{place}, {}}; }

/// Two triangles at the edge from (0, 0, 0) to (0, 0, 1), which is edge 0: the first one level towards +x,
/// the other towards -x and up by an angle: a valley where it is positive, a ridge where it is negative. Both
/// face upwards.
/// @param skew  by which their third corners stand beside the middle of the edge
inline SurfaceMesh hinge(double angle, double skew = 0)
{
    return {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5 + skew}, {-std::cos(angle), std::sin(angle), 0.5 - skew}},
            {{0, 1, 2}, {1, 0, 3}}};
}

/// A prism over an L in the plane of x and y, between z = 0 (vertices 0 to 5) and z = 1 (6 to 11). At its
/// hollow edge, from vertex 3 to vertex 9, a wall that faces +y (x from 1 to 2) meets one that faces +x (y
/// from 1 to 2).
inline SurfaceMesh prism_over_l()
{
    SurfaceMesh mesh;
    for (const double z : {0.0, 1.0})
        for (const auto& [x, y] : {std::pair(0, 0), {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})
            mesh.vertices.emplace_back(x, y, z);
    for (const auto& [a, b] : {std::pair(4, 5), {5, 0}, {0, 1}, {1, 2}}) {
        mesh.faces.push_back({3, b, a});
        mesh.faces.push_back({9, 6 + a, 6 + b});
    }
    for (int i = 0; i < 6; ++i) {
        const int j = (i + 1) % 6;
        mesh.faces.push_back({i, j, 6 + j});
        mesh.faces.push_back({i, 6 + j, 6 + i});
    }
    return mesh;
}

/// Scaled, turned, then moved.
inline SurfaceMesh placed(SurfaceMesh mesh, double scale, const Quaternion& turn = Quaternion::Identity(),
                          const Vec3& place = Vec3::Zero())
{
    for (Vec3& x : mesh.vertices)
        x *= scale;
    return placed(std::move(mesh), turn, place);
}

/// A pair of a vertex with a face of another body, at the face's centre.
inline Contact pair_of(int body_a, int vertex, int body_b, int face, const SurfaceTopology& surface_b)
{
    Contact pair{ContactKind::vertex_face, body_a, body_b, vertex, face, {vertex}, {1}};
    put_on_face(pair, surface_b, face, {1.0 / 3, 1.0 / 3, 1.0 / 3});
    return pair;
}

/// Random numbers that are the same in every run.
class Draw {
public:
    explicit Draw(unsigned seed) : generator_(seed) {}
    double between(double low, double high)
    {
        return std::uniform_real_distribution<>(low, high)(generator_);
    }
    Vec3 direction()
    {
        std::normal_distribution<> normal;
        const double x = normal(generator_), y = normal(generator_), z = normal(generator_);
        return Vec3(x, y, z).normalized();
    }
    Quaternion turn() { return Quaternion(Eigen::AngleAxisd(between(0, std::numbers::pi), direction())); }

private:
    std::mt19937 generator_;
};

}  // namespace enduring::chapter08
