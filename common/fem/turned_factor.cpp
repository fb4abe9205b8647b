#include "common/fem/turned_factor.hpp"

#include "common/fem/polar_rotation.hpp"
#include "common/fem/stiffness_assembly.hpp"

#include <Eigen/CholmodSupport>

#include <stdexcept>

namespace enduring {

/// CHOLMOD orders the unknowns and finds the factor's sparsity once; it takes dense blocks where they pay.
struct TurnedFactor::Cholesky {
    explicit Cholesky(const ElasticMesh& mesh) : assembly(mesh)
    {
        solver.cholmod().supernodal_switch = 500;  // operations per entry of the factor; below it plain columns solve faster
        solver.analyzePattern(assembly.pattern());
    }
    StiffnessAssembly assembly;
    Eigen::CholmodDecomposition<Eigen::SparseMatrix<double>, Eigen::Lower> solver;
};

TurnedFactor::TurnedFactor(const ElasticMesh& mesh) : mesh_(mesh) {}

TurnedFactor::~TurnedFactor() = default;

void TurnedFactor::factor(const CorotatedElasticity& elasticity, const Eigen::VectorXd& masses,
                          const std::vector<char>& fixed, double mass_scale, double stiffness_scale)
{
    if (!cholesky_)
        cholesky_ = std::make_unique<Cholesky>(mesh_);
    cholesky_->solver.factorize(cholesky_->assembly.assemble(elasticity, masses, fixed, mass_scale, stiffness_scale));
    if (cholesky_->solver.info() != Eigen::Success)
        throw std::runtime_error("the elastic system could not be factored");
    mass_scale_ = mass_scale;
    stiffness_scale_ = stiffness_scale;
    rotations_when_factored_ = elasticity.rotations();
    turns_.assign(mesh_.node_count(), Mat3::Identity());
}

bool TurnedFactor::matches(double mass_scale, double stiffness_scale) const
{
    return !turns_.empty() && mass_scale == mass_scale_ && stiffness_scale == stiffness_scale_;
}

//! [turn]
void TurnedFactor::turn(const ElementRotations& rotations)
{
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
    z.resize(3, r.cols());
    for (Eigen::Index n = 0; n < r.cols(); ++n)
        z.col(n) = turns_[n].transpose() * r.col(n);
    const Eigen::VectorXd solved = cholesky_->solver.solve(z.reshaped());
    for (Eigen::Index n = 0; n < r.cols(); ++n)
        z.col(n) = turns_[n] * solved.segment<3>(3 * n);
}
//! [turn]

}  // namespace enduring
