#pragma once

#include "common/fem/basis.hpp"
#include "common/geometry/meshes.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace enduring {

/// One vector a node, in the order of the nodes: positions, velocities, forces.
using NodalVectors = Eigen::Matrix3Xd;

/// A tetrahedron at rest.
struct ElasticElement {
    std::array<int, 10> nodes{};            ///< 4 or 10 of them used
    Eigen::Matrix<double, 3, 4> gradients;  ///< of the barycentric coordinates, one a column [1/m]
    double volume = 0;                      ///< [m^3], positive
};

/// The rest shape of an elastic body. Its nodes are what moves: the corners of a linear element; the corners
/// and the six edge control points of a quadratic one, which start in the middles of the edges but are not
/// points of the body once an edge is curved (SurfaceEmbedding says where the surface is).
class ElasticMesh {
public:
    /// @throws InputError  no element, a node index out of range, or an
    ///     element whose volume is not positive (named)
    explicit ElasticMesh(const TetrahedralMesh& mesh);
    /// @throws InputError  as above; or an element that is not straight-sided:
    ///     a middle node off the middle of its edge
    explicit ElasticMesh(const QuadraticTetrahedralMesh& mesh);

    Basis basis() const { return basis_; }
    int node_count() const { return static_cast<int>(rest_.cols()); }
    const NodalVectors& rest() const { return rest_; }
    const std::vector<ElasticElement>& elements() const { return elements_; }
    double volume() const;

private:
    template <class Mesh>
    void read(const Mesh& mesh);

    Basis basis_;
    NodalVectors rest_;
    std::vector<ElasticElement> elements_;
};

}  // namespace enduring
