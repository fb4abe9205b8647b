#include "common/geometry/surface_extraction.hpp"

#include <algorithm>

namespace enduring {
namespace {

/// One face of one element, filed under its corners in ascending order.
struct ElementFace {
    std::array<int, 3> corners;
    int element, face;
};

template <class Element>
std::vector<ElementFace> faces_by_corners(const std::vector<Element>& elements)
{
    std::vector<ElementFace> faces;
    faces.reserve(4 * elements.size());
    for (int e = 0; e < static_cast<int>(elements.size()); ++e)
        for (int f = 0; f < 4; ++f) {
            std::array<int, 3> corners{};
            for (std::size_t i = 0; i < 3; ++i) {
                const int local = tetrahedron_faces[f][i];
                corners[i] = elements[e][local];
            }
            std::sort(corners.begin(), corners.end());
            faces.push_back({corners, e, f});
        }
    std::stable_sort(faces.begin(), faces.end(),
                     [](const auto& a, const auto& b) { return a.corners < b.corners; });
    return faces;
}

/// Calls visit(first, last) for every run of equal faces.
template <class Visit>
void for_each_distinct(const std::vector<ElementFace>& faces, const Visit& visit)
{
    for (std::size_t first = 0, last = 0; first < faces.size(); first = last) {
        while (last < faces.size() && faces[last].corners == faces[first].corners)
            ++last;
        visit(first, last);
    }
}

/// Faces of one element only, back in the order of the elements.
template <class Element>
std::vector<ElementFace> outer_faces(const std::vector<Element>& elements)
{
    const std::vector<ElementFace> all = faces_by_corners(elements);
    std::vector<ElementFace> outer;
    for_each_distinct(all, [&](std::size_t first, std::size_t last) {
        if (last - first == 1)
            outer.push_back(all[first]);
    });
    std::sort(outer.begin(), outer.end(), [](const auto& a, const auto& b) {
        return a.element != b.element ? a.element < b.element : a.face < b.face;
    });
    return outer;
}

/// Keeps the nodes that the faces name, and renumbers the faces to them.
ExtractedSurface compact(const std::vector<Vec3>& nodes, std::vector<Face> faces)
{
    std::vector<int> vertex_of_node(nodes.size(), -1);
    for (const Face& face : faces)
        for (int node : face)
            vertex_of_node[node] = 0;

    ExtractedSurface surface;
    for (std::size_t n = 0; n < nodes.size(); ++n)
        if (vertex_of_node[n] == 0) {
            vertex_of_node[n] = static_cast<int>(surface.nodes.size());
            surface.nodes.push_back(static_cast<int>(n));
            surface.mesh.vertices.push_back(nodes[n]);
        }
    for (Face& face : faces)
        for (int& node : face)
            node = vertex_of_node[node];
    surface.mesh.faces = std::move(faces);
    return surface;
}

/// The node in the middle of the edge between two local corners of a 10-node element.
int middle(const std::array<int, 10>& element, int i, int j)
{
    for (std::size_t e = 0; e < tetrahedron_edges.size(); ++e)
        if (tetrahedron_edges[e] == std::array{std::min(i, j), std::max(i, j)})
            return element[4 + e];
    return -1;
}

}  // namespace

ExtractedSurface surface_of(const TetrahedralMesh& mesh)
{
    std::vector<Face> faces;
    for (const auto& [corners, e, f] : outer_faces(mesh.elements)) {
        const auto& element = mesh.elements[e];
        const auto& [i, j, k] = tetrahedron_faces[f];
        faces.push_back({element[i], element[j], element[k]});
    }
    return compact(mesh.nodes, std::move(faces));
}

ExtractedSurface surface_of(const QuadraticTetrahedralMesh& mesh)
{
    std::vector<Face> faces;
    for (const auto& [corners, e, f] : outer_faces(mesh.elements)) {
        const auto& element = mesh.elements[e];
        const auto& [i, j, k] = tetrahedron_faces[f];
        const int a = element[i], b = element[j], c = element[k];
        const int ab = middle(element, i, j), bc = middle(element, j, k), ca = middle(element, k, i);
        faces.insert(faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return compact(mesh.nodes, std::move(faces));
}

std::vector<std::array<int, 3>> faces_of_three_elements(const TetrahedralMesh& mesh)
{
    const std::vector<ElementFace> all = faces_by_corners(mesh.elements);
    std::vector<std::array<int, 3>> crowded;
    for_each_distinct(all, [&](std::size_t first, std::size_t last) {
        if (last - first > 2)
            crowded.push_back(all[first].corners);
    });
    return crowded;
}

}  // namespace enduring
