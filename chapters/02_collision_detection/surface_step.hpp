#pragma once

#include "chapters/02_collision_detection/query.hpp"
#include "common/simulation/body.hpp"

namespace enduring {

/// A whole surface over one step: who is whose neighbour, and every
/// vertex at both ends [m]. A view: it owns nothing.
struct SurfaceStep {
    const SurfaceTopology& topology;
    std::span<const Vec3> t0, t1;

    const Vec3& start(int vertex) const { return t0[vertex]; }
    const Vec3& end(int vertex) const { return t1[vertex]; }
    const Face& face(int index) const { return topology.faces()[index]; }
    const Edge& edge(int index) const { return topology.edges()[index]; }
};

inline SurfaceStep surface_step(const Body& body)
{
    return {body.surface(), body.contact_t0(), body.contact_t1()};
}

/// A vertex of one surface against a face of another.
inline VertexFaceStep vertex_face_step(const SurfaceStep& a, int vertex, const SurfaceStep& b, int face)
{
    const auto [f0, f1, f2] = b.face(face);
    return {a.start(vertex), b.start(f0), b.start(f1), b.start(f2),
            a.end(vertex),   b.end(f0),   b.end(f1),   b.end(f2)};
}

/// An edge of one surface against an edge of another, each from its smaller vertex to its larger.
inline EdgeEdgeStep edge_edge_step(const SurfaceStep& a, int edge_a, const SurfaceStep& b, int edge_b)
{
    const auto [a0, a1] = a.edge(edge_a);
    const auto [b0, b1] = b.edge(edge_b);
    return {a.start(a0), a.start(a1), b.start(b0), b.start(b1), a.end(a0), a.end(a1), b.end(b0), b.end(b1)};
}

}  // namespace enduring
