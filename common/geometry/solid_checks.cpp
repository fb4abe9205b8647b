#include "common/geometry/solid_checks.hpp"

#include "common/geometry/element_quality.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/surface_checks.hpp"
#include "common/geometry/surface_extraction.hpp"
#include "common/input/input_error.hpp"

#include <algorithm>
#include <utility>

namespace enduring {
namespace {

template <class Mesh>
void check_elements(const Mesh& mesh, const std::string& what)
{
    constexpr std::size_t node_count = std::tuple_size_v<typename decltype(mesh.elements)::value_type>;
    if (mesh.elements.empty())
        throw InputError(what + ": the mesh has no elements");
    std::vector<bool> used(mesh.nodes.size(), false);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const std::string name = what + ": element " + std::to_string(e) + " ";
        std::array<Vec3, node_count> x;
        for (std::size_t i = 0; i < node_count; ++i) {
            const int node = mesh.elements[e][i];
            if (node < 0 || node >= static_cast<int>(mesh.nodes.size()))
                throw InputError(name + "names node " + std::to_string(node) + ", which does not exist");
            used[node] = true;
            x[i] = mesh.nodes[node];
            if (!x[i].allFinite())
                throw InputError(what + ": node " + std::to_string(node) +
                                 " has a coordinate that is not finite");
        }
        if (const std::string fault = element_fault(x); !fault.empty())
            throw InputError(name + fault);
    }
    for (std::size_t n = 0; n < used.size(); ++n)
        if (!used[n])
            throw InputError(what + ": node " + std::to_string(n) + " belongs to no element");
}

/// An element given twice would have each of its faces twice, and its neighbours three.
void check_no_element_twice(const TetrahedralMesh& mesh, const std::string& what)
{
    std::vector<std::pair<std::array<int, 4>, std::size_t>> sorted;
    sorted.reserve(mesh.elements.size());
    for (std::array<int, 4> nodes : mesh.elements) {
        std::sort(nodes.begin(), nodes.end());
        sorted.emplace_back(nodes, sorted.size());
    }
    std::sort(sorted.begin(), sorted.end());
    const auto twin = std::adjacent_find(sorted.begin(), sorted.end(),
                                         [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twin != sorted.end())
        throw InputError(what + ": element " + std::to_string(std::next(twin)->second) +
                         " has the same nodes as element " + std::to_string(twin->second));
}

void check_faces(const TetrahedralMesh& mesh, const std::string& what)
{
    check_no_element_twice(mesh, what);
    const auto crowded = faces_of_three_elements(mesh);
    if (!crowded.empty())
        throw InputError(what + ": more than two elements share the face over nodes " +
                         std::to_string(crowded[0][0]) + ", " + std::to_string(crowded[0][1]) + " and " +
                         std::to_string(crowded[0][2]));
}

}  // namespace

void check_solid(const TetrahedralMesh& mesh, const std::string& what)
{
    check_elements(mesh, what);
    check_faces(mesh, what);
    const ExtractedSurface surface = surface_of(mesh);
    check_surface(surface.mesh, what, Border::refused, surface.nodes);
}

void check_solid(const QuadraticTetrahedralMesh& mesh, const std::string& what)
{
    check_elements(mesh, what);
    check_faces(corners_of(mesh), what);
    const ExtractedSurface surface = surface_of(mesh);
    check_surface(surface.mesh, what, Border::refused, surface.nodes);
}

}  // namespace enduring
