#pragma once

#include "common/fem/elasticity.hpp"
#include "common/fem/material.hpp"

#include <Eigen/Core>

namespace enduring {

/// The rotation of every element from its mean deformation gradient (its value at the centroid).
void find_rotations(const ElasticMesh& mesh, const NodalVectors& positions, ElementRotations& rotations);

/// Whether an element is turned inside out: a deformation gradient with determinant <= 0 at the element
/// (linear) or at one of its corners (quadratic).
bool is_inverted(Basis basis, const ElasticElement& element, const NodalVectors& positions);
/// How many are.
int inverted_elements(const ElasticMesh& mesh, const NodalVectors& positions);

/// Stiffness of one element in its rest orientation, 3n x 3n for n nodes, node by node [N/m]: K_e = V sum_kl
/// m_kl B_k^T E B_l (thesis 3.18, whose K_e = V B^T E B is the linear element with its one point).
Eigen::MatrixXd element_stiffness(const ElasticMesh& mesh, int element,
                                  const Eigen::Matrix<double, 6, 6>& hooke);

/// The body's elasticity with the elements turned by given rotations: forces f = -K_R (x - R X), where
/// K_R = sum_e R_e K_e R_e^T and "R X" stands for the rest shape of each element turned with it.
/// Keeps references to the mesh and the rotations.
class CorotatedElasticity final : public Elasticity {
public:
    CorotatedElasticity(const ElasticMesh& mesh, const LameConstants& lame, const ElementRotations& rotations)
        : Elasticity(mesh, rotations), lame_(lame)
    {}

    /// Nothing to do: K_R is what the rotations make it.
    void linearise(const NodalVectors&) override {}
    void add_forces(const NodalVectors& positions, NodalVectors& forces) const override;
    void add_stiffness_times(const NodalVectors& v, double scale, NodalVectors& result) const override;
    /// Half of strain times stress, over the body [J].
    double energy(const NodalVectors& positions) const override;
    Eigen::MatrixXd stiffness_of(int element) const override;
    Mat3 axes_of(int element) const override { return rotations_[element]; }

private:
    LameConstants lame_;
};

}  // namespace enduring
