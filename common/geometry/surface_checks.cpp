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
    [[noreturn]] void operator()(const std::string& reason) const { throw InputError(what + ": " + reason); }
};

std::string name_of(const Edge& edge)
{
    return "the edge between vertices " + std::to_string(edge[0]) + " and " + std::to_string(edge[1]);
}

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
    std::vector<Face> sorted = mesh.faces;
    for (Face& face : sorted)
        std::sort(face.begin(), face.end());
    std::sort(sorted.begin(), sorted.end());
    const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
    if (twin != sorted.end())
        complain("two faces over the same vertices " + std::to_string((*twin)[0]) + ", " +
                 std::to_string((*twin)[1]) + " and " + std::to_string((*twin)[2]));
}

SurfaceTopology topology_of(const SurfaceMesh& mesh, const Complaint& complain)
try {
    return {static_cast<int>(mesh.vertices.size()), mesh.faces};
} catch (const InputError& error) {
    complain(error.what());
}

void check_topology(const SurfaceTopology& surface, Border border, const Complaint& complain)
{
    if (!surface.is_manifold())
        complain(
            "the surface is not manifold: an edge has more than two faces, or two parts touch in one vertex only");
    if (!surface.is_consistently_oriented())
        complain("neighbouring faces of the surface face opposite ways");
    if (border == Border::allowed)
        return;
    for (std::size_t e = 0; e < surface.edges().size(); ++e)
        if (surface.faces_at_edge(static_cast<int>(e))[1] < 0)
            complain("the surface is not closed: " + name_of(surface.edges()[e]) +
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

void check_surface(const SurfaceMesh& mesh, const std::string& what, Border border)
{
    const Complaint complain{what};
    const SurfaceTopology surface = topology_of(mesh, complain);  // its faces name vertices that exist
    check_vertices(mesh, complain);
    check_areas(mesh, complain);
    check_no_face_twice(mesh, complain);
    check_topology(surface, border, complain);
    if (border == Border::refused && !(enclosed_volume(mesh) > 0))
        complain("the surface faces inwards: turn its faces around");
}

}  // namespace enduring
