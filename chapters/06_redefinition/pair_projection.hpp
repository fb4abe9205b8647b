#pragma once

#include "chapters/03_penalty_impulses/penetration.hpp"
#include "chapters/05_categorisation/normal_span.hpp"
#include "common/geometry/triangle_foot.hpp"
#include "common/simulation/contact.hpp"
#include "common/simulation/rest_neighbours.hpp"
#include "common/simulation/step.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace enduring {

/// Which features of two bodies never meet: none, but for a body with itself.
inline const RestNeighbours* rest_neighbours(const World& world, int body_a, int body_b)
{
    return body_a == body_b ? rest_neighbours(*world.bodies[body_a]) : nullptr;
}

/// The surfaces of a pair's two bodies at one moment of the step.
struct PairSurfaces {
    SurfaceMoment a, b;
    const RestNeighbours* neighbours;

    PairSurfaces(const World& world, int body_a, int body_b, double tau)
        : a(surface_at(*world.bodies[body_a], tau)), b(surface_at(*world.bodies[body_b], tau)),
          neighbours(rest_neighbours(world, body_a, body_b))
    {}
    PairSurfaces(const World& world, const Contact& contact, double tau)
        : PairSurfaces(world, contact.body_a, contact.body_b, tau)
    {}
};

//! [face_foot]
/// None for a face without area.
inline std::optional<TriangleFoot> foot_on_face(const SurfaceMoment& a, int vertex, const SurfaceMoment& b,
                                                int face)
{
    const auto [f0, f1, f2] = b.step.face(face);
    return foot_on_triangle(a.position(vertex), b.position(f0), b.position(f1), b.position(f2));
}

/// How far the weights leave [0, 1], thesis (6.4): 0 for a foot on the face. Their sum is
/// 1, so the one that exceeds 1 does it by no more than the others fall short of 0
/// together; the thesis' definition takes the largest of all.
inline double overshoot(const std::array<double, 3>& weights)
{
    double worst = 0;
    for (const double w : weights)
        worst = std::max({worst, -w, w - 1});
    return worst;
}
//! [face_foot]

//! [edge_feet]
/// The points at which two edges' lines cross when they are looked at along the contact normal.
struct EdgeFeet {
    double s, t;   ///< (1-s) a0 + s a1 and (1-t) b0 + t b1; outside [0, 1] beyond an end
    Vec3 normal;   ///< unit length, from B to A as `orientation` says
    double depth;  ///< normal . (p - q) [m]

    /// Both points lie on their edges, give or take this part of an edge's length.
    bool overlap(double tolerance) const
    {
        const auto on_edge = [&](double w) { return -tolerance <= w && w <= 1 + tolerance; };
        return on_edge(s) && on_edge(t);
    }
};

/// None for edges closer to parallel than `smallest_sine`: their lines cross everywhere or nowhere.
/// @param x  a0 a1 b0 b1
inline std::optional<EdgeFeet> feet_of_edges(const PairVertices& x, double orientation,
                                             double smallest_sine = 0)
{
    const Vec3 along_a = x[1] - x[0], along_b = x[3] - x[2], across = along_a.cross(along_b),
               apart = x[2] - x[0];
    const double squared_length = across.squaredNorm();
    if (!(squared_length > smallest_sine * smallest_sine * along_a.squaredNorm() * along_b.squaredNorm()))
        return std::nullopt;
    const Vec3 normal = orientation / std::sqrt(squared_length) * across;
    return EdgeFeet{apart.cross(along_b).dot(across) / squared_length,
                    apart.cross(along_a).dot(across) / squared_length, normal, -normal.dot(apart)};
}
//! [edge_feet]

/// a0 a1 b0 b1 of an edge pair at one moment.
inline PairVertices edge_vertices(const PairSurfaces& surfaces, int edge_a, int edge_b)
{
    const auto [a0, a1] = surfaces.a.step.edge(edge_a);
    const auto [b0, b1] = surfaces.b.step.edge(edge_b);
    return {surfaces.a.position(a0), surfaces.a.position(a1), surfaces.b.position(b0),
            surfaces.b.position(b1)};
}

/// Lets a vertex-face contact act at a foot.
inline void put_on_face(Contact& contact, const SurfaceTopology& surface_b, int face,
                        const std::array<double, 3>& weights)
{
    const Face& corners = surface_b.faces()[face];
    contact.feature_b = face;
    for (std::size_t i = 0; i < 3; ++i) {
        contact.vertices[i + 1] = corners[i];
        contact.weights[i + 1] = -weights[i];
    }
}

/// Lets an edge-edge contact act at its feet.
inline void put_at(Contact& contact, const EdgeFeet& feet)
{
    contact.weights = {1 - feet.s, feet.s, feet.t - 1, -feet.t};
}

}  // namespace enduring
