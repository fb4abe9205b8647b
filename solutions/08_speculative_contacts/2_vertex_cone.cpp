#include "exercises/08_speculative_contacts/2_vertex_cone.hpp"

#include <algorithm>
#include <set>

namespace enduring {
namespace {

bool stands_at(const Face& face, int vertex)
{
    return std::find(face.begin(), face.end(), vertex) != face.end();
}

Vec3 position(const SurfaceMesh& mesh, int vertex) { return mesh.vertices[static_cast<std::size_t>(vertex)]; }

}  // namespace

std::vector<int> neighbours_of(const SurfaceMesh& mesh, int vertex)
{
    std::set<int> found;
    for (const Face& face : mesh.faces)
        if (stands_at(face, vertex))
            found.insert(face.begin(), face.end());
    found.erase(vertex);
    return {found.begin(), found.end()};
}

double worst_sine(const SurfaceMesh& mesh, int vertex, const Vec3& direction)
{
    double worst = -1;
    for (const int other : neighbours_of(mesh, vertex)) {
        const Vec3 path = position(mesh, other) - position(mesh, vertex);
        worst = std::max(worst, path.dot(direction) / path.norm());
    }
    return worst;
}

bool in_cone(const SurfaceMesh& mesh, int vertex, const Vec3& direction, double sine)
{
    const bool looks_out = std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& face) {
        const Vec3 corner = position(mesh, face[0]);
        const Vec3 normal = (position(mesh, face[1]) - corner).cross(position(mesh, face[2]) - corner);
        return stands_at(face, vertex) && normal.dot(direction) > 0;
    });
    return looks_out && worst_sine(mesh, vertex, direction) <= sine;
}

std::optional<Vec3> direction_in_cone(const SurfaceMesh& mesh, int vertex)
{
    const std::vector<int> neighbours = neighbours_of(mesh, vertex);
    for (const int one : neighbours)
        for (const int other : neighbours) {
            const Vec3 across = (position(mesh, one) - position(mesh, vertex))
                                    .cross(position(mesh, other) - position(mesh, vertex))
                                    .stableNormalized();
            if (across.norm() > 0.5 && in_cone(mesh, vertex, across, 1e-9))
                return across;
        }
    return std::nullopt;
}

}  // namespace enduring
