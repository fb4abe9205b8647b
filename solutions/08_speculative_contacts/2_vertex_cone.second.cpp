#include "exercises/08_speculative_contacts/2_vertex_cone.hpp"
#include "common/geometry/surface_topology.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

std::vector<Vec3> ways_from(const SurfaceMesh& mesh, int vertex)
{
    std::vector<Vec3> ways;
    for (const int other : neighbours_of(mesh, vertex))
        ways.push_back(
            (mesh.vertices[static_cast<std::size_t>(other)] - mesh.vertices[static_cast<std::size_t>(vertex)])
                .normalized());
    return ways;
}

}  // namespace

std::vector<int> neighbours_of(const SurfaceMesh& mesh, int vertex)
{
    std::vector<int> all;
    for (const auto& [p, q, r] : mesh.faces)
        if (p == vertex || q == vertex || r == vertex)
            for (const int other : {p, q, r})
                if (other != vertex)
                    all.push_back(other);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

double worst_sine(const SurfaceMesh& mesh, int vertex, const Vec3& direction)
{
    double worst = -INFINITY;
    for (const Vec3& way : ways_from(mesh, vertex))
        worst = std::max(worst, way.dot(direction));
    return worst;
}

bool in_cone(const SurfaceMesh& mesh, int vertex, const Vec3& direction, double sine)
{
    if (worst_sine(mesh, vertex, direction) > sine)
        return false;
    for (const auto& [p, q, r] : mesh.faces) {
        if (p != vertex && q != vertex && r != vertex)
            continue;
        Mat3 columns;
        columns << mesh.vertices[static_cast<std::size_t>(q)] - mesh.vertices[static_cast<std::size_t>(p)],
            mesh.vertices[static_cast<std::size_t>(r)] - mesh.vertices[static_cast<std::size_t>(p)],
            direction;
        if (columns.determinant() > 0)
            return true;
    }
    return false;
}

std::optional<Vec3> direction_in_cone(const SurfaceMesh& mesh, int vertex)
{
    const std::vector<Vec3> ways = ways_from(mesh, vertex);
    for (std::size_t i = 0; i < ways.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (const double sign : {1.0, -1.0}) {
                const Vec3 across = sign * ways[i].cross(ways[j]);
                if (across.norm() > 1e-9 && in_cone(mesh, vertex, across.normalized(), 1e-9))
                    return across.normalized();
            }
    return std::nullopt;
}

}  // namespace enduring
