#pragma once

#include <array>
#include <span>
#include <vector>

namespace enduring {

using Face = std::array<int, 3>;  ///< vertex indices, counter-clockwise seen from outside
using Edge = std::array<int, 2>;  ///< vertex indices, the smaller first

/// Who is whose neighbour on a triangle surface. Holds no positions, so
/// one topology serves a body for its whole life.
///
/// The neighbourhoods are compact arrays (offsets into one list), read
/// as spans; every list is in ascending order.
class SurfaceTopology {
public:
    SurfaceTopology() = default;

    /// @param vertex_count  number of vertices; every face index lies in [0, vertex_count)
    /// @param faces         triangles, counter-clockwise seen from outside
    /// @throws InputError   an index out of range, or a face that names a vertex twice
    SurfaceTopology(int vertex_count, std::vector<Face> faces);

    /// What has points and edges alone: a wire frame, or with no edges a cloud of points. It has no inside,
    /// and is not closed.
    /// @param edges         vertex indices in [0, vertex_count), in any order
    /// @throws InputError   an index out of range, an edge that names a vertex twice, an edge twice
    static SurfaceTopology of_edges(int vertex_count, std::vector<Edge> edges);

    int vertex_count() const { return vertex_count_; }
    std::span<const Face> faces() const { return faces_; }
    std::span<const Edge> edges() const { return edges_; }

    std::span<const int> faces_around_vertex(int vertex) const;
    std::span<const int> edges_around_vertex(int vertex) const;
    /// The two faces at an edge, in ascending order; the second is -1 on an open border, both are on a wire.
    const std::array<int, 2>& faces_at_edge(int edge) const;
    /// Edges of a face: {f0 f1}, {f1 f2}, {f2 f0}.
    const std::array<int, 3>& edges_of_face(int face) const;

    bool has_one_fan(int vertex) const;     ///< its faces are neighbours, one after the other
    bool is_closed() const;                 ///< it has faces, and every edge has two of them
    bool is_manifold() const;               ///< at most two faces an edge, and one fan a vertex
    bool is_consistently_oriented() const;  ///< neighbours run along their common edge in opposite directions

private:
    int vertex_count_ = 0;
    std::vector<Face> faces_;
    std::vector<Edge> edges_;
    std::vector<int> vertex_face_offsets_, vertex_faces_;
    std::vector<int> vertex_edge_offsets_, vertex_edges_;
    std::vector<std::array<int, 2>> edge_faces_;
    std::vector<std::array<int, 3>> face_edges_;
    bool manifold_ = true, oriented_ = true;
};

}  // namespace enduring
