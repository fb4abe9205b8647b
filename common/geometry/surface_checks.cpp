#include "common/geometry/surface_checks.hpp"

#include "common/geometry/tolerances.hpp"
#include "common/input/input_error.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

/// Collects a complaint and names the mesh in front of it.
struct Complaint {
    const std::string& what;
    const std::vector<int>& nodes;  ///< of a solid, that its vertices are; empty for a surface of its own
    [[noreturn]] void operator()(const std::string& reason) const { throw InputError(what + ": " + reason); }

    std::string number(int vertex) const
    {
        return std::to_string(nodes.empty() ? vertex : nodes[static_cast<std::size_t>(vertex)]);
    }
    std::string name(int vertex) const { return (nodes.empty() ? "vertex " : "node ") + number(vertex); }
    std::string name(const Edge& edge) const
    {
        return std::string("the edge between ") + (nodes.empty() ? "vertices " : "nodes ") + number(edge[0]) +
               " and " + number(edge[1]);
    }
    /// "faces 1, 2 and 5", or "3 faces" of a solid.
    std::string name(const std::vector<int>& faces) const
    {
        if (!nodes.empty())
            return std::to_string(faces.size()) + " faces";
        std::string text = "faces ";
        for (std::size_t i = 0; i < faces.size(); ++i)
            text += (i == 0 ? "" : i + 1 == faces.size() ? " and " : ", ") + std::to_string(faces[i]);
        return text;
    }
};

void check_vertices(const SurfaceMesh& mesh, const Complaint& complain)
{
    if (mesh.faces.empty())
        complain("the surface has no faces");
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const Face& face : mesh.faces)
        for (int vertex : face)
            used[vertex] = true;
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (!mesh.vertices[v].allFinite())
            complain("vertex " + std::to_string(v) + " has a coordinate that is not finite");
        if (!used[v])
            complain("vertex " + std::to_string(v) + " belongs to no face");
    }
}

void check_areas(const SurfaceMesh& mesh, const Complaint& complain)
{
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const auto corner = [&](std::size_t i) { return mesh.vertices[mesh.faces[f][i]]; };
        const Vec3 a = corner(1) - corner(0), b = corner(2) - corner(0), c = b - a;
        const double longest = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
        if (!(a.cross(b).norm() > tolerance::least_area * longest))
            complain("face " + std::to_string(f) + " has no area");
    }
}

void check_no_face_twice(const SurfaceMesh& mesh, const Complaint& complain)
{
    std::vector<std::pair<Face, std::size_t>> sorted;
    sorted.reserve(mesh.faces.size());
    for (Face corners : mesh.faces) {
        std::sort(corners.begin(), corners.end());
        sorted.emplace_back(corners, sorted.size());
    }
    std::sort(sorted.begin(), sorted.end());
    const auto twin = std::adjacent_find(sorted.begin(), sorted.end(),
                                         [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twin == sorted.end())
        return;
    const auto& [corners, face] = *twin;
    complain("faces " + std::to_string(face) + " and " + std::to_string(std::next(twin)->second) +
             " are two over the same vertices " + std::to_string(corners[0]) + ", " +
             std::to_string(corners[1]) + " and " + std::to_string(corners[2]));
}

SurfaceTopology topology_of(const SurfaceMesh& mesh, const Complaint& complain)
try {
    return {static_cast<int>(mesh.vertices.size()), mesh.faces};
} catch (const InputError& error) {
    complain(error.what());
}

/// The first edge of more than two faces, or vertex of more than one fan.
void check_manifold(const SurfaceTopology& surface, const Complaint& complain)
{
    if (surface.is_manifold())
        return;
    std::vector<std::vector<int>> faces_of(surface.edges().size());
    for (int face = 0; face < static_cast<int>(surface.faces().size()); ++face)
        for (const int edge : surface.edges_of_face(face))
            faces_of[static_cast<std::size_t>(edge)].push_back(face);
    for (std::size_t edge = 0; edge < faces_of.size(); ++edge)
        if (faces_of[edge].size() > 2)
            complain("the surface is not manifold: " + complain.name(surface.edges()[edge]) + " belongs to " +
                     complain.name(faces_of[edge]) + ", and at most two may share it");
    for (int vertex = 0; vertex < surface.vertex_count(); ++vertex)
        if (!surface.has_one_fan(vertex))
            complain("the surface is not manifold: two parts of it touch in " + complain.name(vertex) +
                     " only, of " +
                     complain.name(std::vector<int>(surface.faces_around_vertex(vertex).begin(),
                                                    surface.faces_around_vertex(vertex).end())));
}

/// The first edge along which its two faces run the same way.
void check_orientation(const SurfaceTopology& surface, const Complaint& complain)
{
    const auto runs_forward = [&](int face, const Edge& edge) {
        const Face& corners = surface.faces()[static_cast<std::size_t>(face)];
        for (std::size_t i = 0; i < 3; ++i)
            if (corners[i] == edge[0] && corners[(i + 1) % 3] == edge[1])
                return true;
        return false;
    };
    for (std::size_t e = 0; e < surface.edges().size(); ++e) {
        const auto& [one, other] = surface.faces_at_edge(static_cast<int>(e));
        const Edge& edge = surface.edges()[e];
        if (other >= 0 && runs_forward(one, edge) == runs_forward(other, edge))
            complain("faces " + std::to_string(one) + " and " + std::to_string(other) +
                     ", neighbours of the surface, face opposite ways: both run along " +
                     complain.name(edge) + " in the same direction");
    }
}

void check_topology(const SurfaceTopology& surface, Border border, const Complaint& complain)
{
    check_manifold(surface, complain);
    check_orientation(surface, complain);
    if (border == Border::allowed)
        return;
    for (std::size_t e = 0; e < surface.edges().size(); ++e)
        if (surface.faces_at_edge(static_cast<int>(e))[1] < 0)
            complain("the surface is not closed: " + complain.name(surface.edges()[e]) +
                     " has one face only (static bodies and sheets alone may have a border)");
}

}  // namespace

double enclosed_volume(const SurfaceMesh& mesh)
{
    if (mesh.vertices.empty())
        return 0;
    const Vec3 origin = mesh.vertices.front();  // far from the origin the sum would cancel
    double sum = 0;
    for (const Face& face : mesh.faces) {
        const auto corner = [&](std::size_t i) -> Vec3 { return mesh.vertices[face[i]] - origin; };
        sum += corner(0).dot(corner(1).cross(corner(2)));
    }
    return sum / 6;
}

SurfaceMesh without_unused_vertices(const SurfaceMesh& mesh)
{
    std::vector<int> renumbered(mesh.vertices.size(), -1);
    for (const Face& face : mesh.faces)
        for (int vertex : face)
            renumbered[vertex] = 0;
    SurfaceMesh result;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (renumbered[v] == 0) {
            renumbered[v] = static_cast<int>(result.vertices.size());
            result.vertices.push_back(mesh.vertices[v]);
        }
    for (Face face : mesh.faces) {
        for (int& vertex : face)
            vertex = renumbered[vertex];
        result.faces.push_back(face);
    }
    return result;
}

void check_surface(const SurfaceMesh& mesh, const std::string& what, Border border,
                   const std::vector<int>& nodes)
{
    const Complaint complain{what, nodes};
    const SurfaceTopology surface = topology_of(mesh, complain);  // its faces name vertices that exist
    check_vertices(mesh, complain);
    check_areas(mesh, complain);
    check_no_face_twice(mesh, complain);
    check_topology(surface, border, complain);
    if (border == Border::refused && !(enclosed_volume(mesh) > 0))
        complain("the surface faces inwards: turn its faces around");
}

}  // namespace enduring
