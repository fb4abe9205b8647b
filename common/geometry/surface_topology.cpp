#include "common/geometry/surface_topology.hpp"

#include "common/input/input_error.hpp"

#include <algorithm>
#include <string>

namespace enduring {
namespace {

/// One side of one face, filed under its edge.
struct Side {
    Edge edge;
    int face;
    int corner;    ///< the side runs from this corner of the face to the next
    bool forward;  ///< from the smaller vertex to the larger
};

void require_valid_faces(int vertex_count, std::span<const Face> faces)
{
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto [a, b, c] = faces[f];
        if (std::min({a, b, c}) < 0 || std::max({a, b, c}) >= vertex_count)
            throw InputError("face " + std::to_string(f) + " names a vertex outside [0, " +
                             std::to_string(vertex_count) + ")");
        if (a == b || b == c || c == a)
            throw InputError("face " + std::to_string(f) + " names a vertex twice");
    }
}

std::vector<Side> sides_by_edge(std::span<const Face> faces)
{
    std::vector<Side> sides;
    sides.reserve(3 * faces.size());
    for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
        const Face& face = faces[f];
        for (int corner = 0; corner < 3; ++corner) {
            const int from = face[corner], to = face[(corner + 1) % 3];
            sides.push_back({{std::min(from, to), std::max(from, to)}, f, corner, from < to});
        }
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return a.edge < b.edge; });
    return sides;
}

/// Files every item under the vertices it names: item i appears in
/// list[offsets[v], offsets[v + 1]) of each of its vertices v.
template <class Items>
void file_under_vertices(int vertex_count, const Items& items, std::vector<int>& offsets,
                         std::vector<int>& list)
{
    offsets.assign(static_cast<std::size_t>(vertex_count) + 1, 0);
    for (const auto& item : items)
        for (int vertex : item)
            ++offsets[static_cast<std::size_t>(vertex) + 1];
    for (std::size_t v = 1; v < offsets.size(); ++v)
        offsets[v] += offsets[v - 1];
    list.resize(static_cast<std::size_t>(offsets.back()));
    std::vector<int> next(offsets.begin(), offsets.end() - 1);
    for (int i = 0; i < static_cast<int>(items.size()); ++i)
        for (int vertex : items[i])
            list[next[static_cast<std::size_t>(vertex)]++] = i;
}

std::span<const int> part(const std::vector<int>& offsets, const std::vector<int>& list, int vertex)
{
    const auto v = static_cast<std::size_t>(vertex);
    return {list.data() + offsets[v], static_cast<std::size_t>(offsets[v + 1] - offsets[v])};
}

}  // namespace

SurfaceTopology::SurfaceTopology(int vertex_count, std::vector<Face> faces)
    : vertex_count_(vertex_count), faces_(std::move(faces)), face_edges_(faces_.size())
{
    require_valid_faces(vertex_count_, faces_);
    const std::vector<Side> sides = sides_by_edge(faces_);
    for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
        while (last < sides.size() && sides[last].edge == sides[first].edge) {
            const auto face = static_cast<std::size_t>(sides[last].face),
                       corner = static_cast<std::size_t>(sides[last].corner);
            face_edges_[face][corner] = static_cast<int>(edges_.size());
            ++last;
        }
        edges_.push_back(sides[first].edge);
        edge_faces_.push_back({sides[first].face, last - first > 1 ? sides[first + 1].face : -1});
        manifold_ = manifold_ && last - first <= 2;
        oriented_ = oriented_ && (last - first == 1 ||
                                  (last - first == 2 && sides[first].forward != sides[first + 1].forward));
    }
    file_under_vertices(vertex_count_, faces_, vertex_face_offsets_, vertex_faces_);
    file_under_vertices(vertex_count_, edges_, vertex_edge_offsets_, vertex_edges_);
    for (int v = 0; v < vertex_count_ && manifold_; ++v)
        manifold_ = has_one_fan(v);
}

SurfaceTopology SurfaceTopology::of_edges(int vertex_count, std::vector<Edge> edges)
{
    for (std::size_t e = 0; e < edges.size(); ++e) {
        Edge& edge = edges[e];
        std::sort(edge.begin(), edge.end());
        if (edge[0] < 0 || edge[1] >= vertex_count)
            throw InputError("edge " + std::to_string(e) + " names a vertex outside [0, " +
                             std::to_string(vertex_count) + ")");
        if (edge[0] == edge[1])
            throw InputError("edge " + std::to_string(e) + " names a vertex twice");
    }
    std::sort(edges.begin(), edges.end());
    if (const auto twice = std::adjacent_find(edges.begin(), edges.end()); twice != edges.end())
        throw InputError("the edge between the vertices " + std::to_string((*twice)[0]) + " and " +
                         std::to_string((*twice)[1]) + " is there twice");
    SurfaceTopology frame(vertex_count, std::vector<Face>{});
    frame.edges_ = std::move(edges);
    frame.edge_faces_.assign(frame.edges_.size(), {-1, -1});
    file_under_vertices(vertex_count, frame.edges_, frame.vertex_edge_offsets_, frame.vertex_edges_);
    return frame;
}

/// Walks from the first face over common edges at the vertex; a bow tie leaves faces unvisited.
bool SurfaceTopology::has_one_fan(int vertex) const
{
    const std::span<const int> faces = faces_around_vertex(vertex);
    if (faces.empty())
        return true;
    std::vector<int> reached{faces[0]};
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (int edge : edges_of_face(reached[i])) {
            const Edge& ends = edges_[edge];
            if (ends[0] != vertex && ends[1] != vertex)
                continue;
            for (int face : faces_at_edge(edge))
                if (face >= 0 && std::find(reached.begin(), reached.end(), face) == reached.end())
                    reached.push_back(face);
        }
    return reached.size() == faces.size();
}

std::span<const int> SurfaceTopology::faces_around_vertex(int vertex) const
{
    return part(vertex_face_offsets_, vertex_faces_, vertex);
}

std::span<const int> SurfaceTopology::edges_around_vertex(int vertex) const
{
    return part(vertex_edge_offsets_, vertex_edges_, vertex);
}

const std::array<int, 2>& SurfaceTopology::faces_at_edge(int edge) const { return edge_faces_[edge]; }

const std::array<int, 3>& SurfaceTopology::edges_of_face(int face) const { return face_edges_[face]; }

bool SurfaceTopology::is_closed() const
{
    return !faces_.empty() && std::all_of(edge_faces_.begin(), edge_faces_.end(),
                                          [](const auto& faces) { return faces[1] >= 0; });
}

bool SurfaceTopology::is_manifold() const { return manifold_; }

bool SurfaceTopology::is_consistently_oriented() const { return oriented_; }

}  // namespace enduring
