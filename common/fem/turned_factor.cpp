#include "common/fem/turned_factor.hpp"

#include "common/fem/polar_rotation.hpp"

#include <stdexcept>

namespace enduring {

void TurnedFactor::factor(const Elasticity& elasticity, const Eigen::SparseMatrix<double>& mass_matrix,
                          const std::vector<char>& fixed, double mass_scale, double stiffness_scale)
{
    if (!solver_) {
        assembly_.emplace(mesh_);
        solver_ = make_linear_solver(kind_, assembly_->pattern());
    }
    if (!solver_->factor(assembly_->assemble(elasticity, mass_matrix, fixed, mass_scale, stiffness_scale)))
        throw std::runtime_error("the elastic system could not be factored");
    mass_scale_ = mass_scale;
    stiffness_scale_ = stiffness_scale;
    rotations_when_factored_ = elasticity.rotations();
    rotations_now_ = rotations_when_factored_;
    turns_.assign(mesh_.node_count(), Mat3::Identity());
}

bool TurnedFactor::matches(double mass_scale, double stiffness_scale) const
{
    return !turns_.empty() && mass_scale == mass_scale_ && stiffness_scale == stiffness_scale_;
}

//! [turn]
void TurnedFactor::turn(const ElementRotations& rotations)
{
    if (rotations == rotations_now_)
        return;
    rotations_now_ = rotations;
    turns_.assign(turns_.size(), Mat3::Zero());
    for (std::size_t e = 0; e < rotations.size(); ++e) {
        const Mat3 since = rotations[e] * rotations_when_factored_[e].transpose();
        for (int i = 0; i < nodes_of(mesh_.basis()); ++i)
            turns_[mesh_.elements()[e].nodes[i]] += since;
    }
    for (Mat3& turn : turns_)
        turn = polar_rotation(turn);
}

void TurnedFactor::apply(const NodalVectors& r, NodalVectors& z) const
{
    Eigen::VectorXd turned(3 * r.cols());
    for (Eigen::Index n = 0; n < r.cols(); ++n)
        turned.segment<3>(3 * n) = turns_[n].transpose() * r.col(n);
    solver_->solve(turned);
    z.resize(3, r.cols());
    for (Eigen::Index n = 0; n < r.cols(); ++n)
        z.col(n) = turns_[n] * turned.segment<3>(3 * n);
}
//! [turn]

void TurnedFactor::apply(std::span<NodalVectors> fields) const
{
    const auto nodes = static_cast<Eigen::Index>(turns_.size());
    Eigen::MatrixXd turned(3 * nodes, static_cast<Eigen::Index>(fields.size()));
    for (Eigen::Index i = 0; i < turned.cols(); ++i)
        for (Eigen::Index n = 0; n < nodes; ++n)
            turned.col(i).segment<3>(3 * n) = turns_[n].transpose() * fields[i].col(n);
    solver_->solve(turned);
    for (Eigen::Index i = 0; i < turned.cols(); ++i)
        for (Eigen::Index n = 0; n < nodes; ++n)
            fields[i].col(n) = turns_[n] * turned.col(i).segment<3>(3 * n);
}

}  // namespace enduring
