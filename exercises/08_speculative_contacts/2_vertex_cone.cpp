#include "exercises/08_speculative_contacts/2_vertex_cone.hpp"
#include "exercises/not_implemented_yet.hpp"

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
    not_implemented_yet("8.2");
}

double worst_sine(const SurfaceMesh& mesh, int vertex, const Vec3& direction)
{
    not_implemented_yet("8.2");
}

bool in_cone(const SurfaceMesh& mesh, int vertex, const Vec3& direction, double sine)
{
    not_implemented_yet("8.2");
}

std::optional<Vec3> direction_in_cone(const SurfaceMesh& mesh, int vertex)
{
    not_implemented_yet("8.2");
}

}  // namespace enduring
