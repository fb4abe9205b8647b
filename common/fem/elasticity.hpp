#pragma once

#include "common/fem/elastic_mesh.hpp"
#include "common/geometry/vector.hpp"

#include <Eigen/Core>

#include <vector>

namespace enduring {

/// One rotation an element.
using ElementRotations = std::vector<Mat3>;

/// What holds a body together, as a step needs it: forces at given positions, and the symmetric positive
/// semidefinite stiffness K by which they change near those of linearise().
/// Keeps references to the mesh and the rotations.
class Elasticity {
public:
    Elasticity(const ElasticMesh& mesh, const ElementRotations& rotations)
        : mesh_(mesh), rotations_(rotations)
    {}
    virtual ~Elasticity() = default;

    const ElasticMesh& mesh() const { return mesh_; }
    /// How far each element has turned: what kept factors and responses turn with.
    const ElementRotations& rotations() const { return rotations_; }

    /// K belongs to these positions from now on; the rotations already do.
    virtual void linearise(const NodalVectors& positions) = 0;
    /// forces += the elastic forces on the nodes at these positions [N].
    virtual void add_forces(const NodalVectors& positions, NodalVectors& forces) const = 0;
    /// result += scale K v, without building K.
    virtual void add_stiffness_times(const NodalVectors& v, double scale, NodalVectors& result) const = 0;
    /// At these positions [J].
    virtual double energy(const NodalVectors& positions) const = 0;

    /// One element's part of K, 3n x 3n for n nodes, node by node, in axes that axes_of() turns into the
    /// world's [N/m].
    virtual Eigen::MatrixXd stiffness_of(int element) const = 0;
    virtual Mat3 axes_of(int element) const = 0;

protected:
    Elasticity(const Elasticity&) = default;

    const ElasticMesh& mesh_;
    const ElementRotations& rotations_;
};

}  // namespace enduring
