#include "common/fem/turned_factor.hpp"

#include "common/fem/block_factor.hpp"
#include "common/fem/polar_rotation.hpp"
#include "common/fem/stiffness_assembly.hpp"

#include <stdexcept>

namespace enduring {

struct TurnedFactor::Cholesky {
    explicit Cholesky(const ElasticMesh& mesh) : assembly(mesh) { factor.analyze(assembly.pattern()); }
    StiffnessAssembly assembly;
    BlockFactor factor;
};

TurnedFactor::TurnedFactor(const ElasticMesh& mesh) : mesh_(mesh) {}

TurnedFactor::~TurnedFactor() = default;

void TurnedFactor::factor(const CorotatedElasticity& elasticity, const Eigen::SparseMatrix<double>& mass_matrix,
                          const std::vector<char>& fixed, double mass_scale, double stiffness_scale)
{
    if (!cholesky_)
        cholesky_ = std::make_unique<Cholesky>(mesh_);
    if (!cholesky_->factor.factor(cholesky_->assembly.assemble(elasticity, mass_matrix, fixed, mass_scale, stiffness_scale)))
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
    cholesky_->factor.solve(turned);
    z.resize(3, r.cols());
    for (Eigen::Index n = 0; n < r.cols(); ++n)
        z.col(n) = turns_[n] * turned.segment<3>(3 * n);
}
//! [turn]

}  // namespace enduring
