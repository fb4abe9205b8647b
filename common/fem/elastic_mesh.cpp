#include "common/fem/elastic_mesh.hpp"

#include "common/geometry/tolerances.hpp"
#include "common/input/input_error.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <string>

namespace enduring {
namespace {

std::string named(std::size_t element) { return "element " + std::to_string(element) + " (counted from 0)"; }

ElasticElement make_element(const std::array<Vec3, 4>& corner, std::size_t index)
{
    Mat3 edges;
    edges << corner[1] - corner[0], corner[2] - corner[0], corner[3] - corner[0];
    const double longest = std::max(edges.colwise().norm().maxCoeff(),
                                    std::max((corner[2] - corner[1]).norm(), (corner[3] - corner[2]).norm()));
    ElasticElement element;
    element.volume = edges.determinant() / 6;
    if (!(element.volume > tolerance::least_volume * longest * longest * longest))
        throw InputError(named(index) + (element.volume < 0 ? " is inverted" : " has no volume") +
                         ": its volume must be positive, not " + std::to_string(element.volume) + " m^3");
    element.gradients.rightCols<3>() = edges.inverse().transpose();
    element.gradients.col(0) = -element.gradients.rightCols<3>().rowwise().sum();
    return element;
}

/// In Bernstein form an edge is straight and evenly parametrised when its control point is the middle.
void demand_straight_edges(const QuadraticTetrahedralMesh& mesh, std::size_t index)
{
    const auto& nodes = mesh.elements[index];
    for (std::size_t e = 0; e < tetrahedron_edges.size(); ++e) {
        const Vec3 &a = mesh.nodes[nodes[tetrahedron_edges[e][0]]],
                   &b = mesh.nodes[nodes[tetrahedron_edges[e][1]]];
        const double off = (mesh.nodes[nodes[4 + e]] - 0.5 * (a + b)).norm();
        if (!(off <= tolerance::straight_edge * (b - a).norm()))
            throw InputError(named(index) + " is curved at rest: node " + std::to_string(nodes[4 + e]) +
                             " must be in the middle of its edge");
    }
}

}  // namespace

template <class Mesh>
void ElasticMesh::read(const Mesh& mesh)
{
    if (mesh.elements.empty())
        throw InputError("an elastic body needs at least one element");
    const int count = static_cast<int>(mesh.nodes.size());
    rest_.resize(3, count);
    for (int n = 0; n < count; ++n)
        rest_.col(n) = mesh.nodes[n];

    elements_.reserve(mesh.elements.size());
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const auto& nodes = mesh.elements[e];
        for (int node : nodes)
            if (node < 0 || node >= count)
                throw InputError(named(e) + " names node " + std::to_string(node) + "; allowed are 0 to " +
                                 std::to_string(count - 1));
        elements_.push_back(make_element(
            {mesh.nodes[nodes[0]], mesh.nodes[nodes[1]], mesh.nodes[nodes[2]], mesh.nodes[nodes[3]]}, e));
        std::copy(nodes.begin(), nodes.end(), elements_.back().nodes.begin());
    }
}

ElasticMesh::ElasticMesh(const TetrahedralMesh& mesh) : basis_(Basis::linear) { read(mesh); }

ElasticMesh::ElasticMesh(const QuadraticTetrahedralMesh& mesh) : basis_(Basis::quadratic)
{
    read(mesh);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        demand_straight_edges(mesh, e);
}

double ElasticMesh::volume() const
{
    double sum = 0;
    for (const ElasticElement& element : elements_)
        sum += element.volume;
    return sum;
}

}  // namespace enduring
