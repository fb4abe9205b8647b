#include "common/fem/whole_matrix.hpp"

#include <algorithm>
#include <utility>

namespace enduring {
namespace {

Eigen::VectorXd as_vector(const NodalVectors& field) { return field.reshaped(); }

}  // namespace

Eigen::VectorXd WholeMatrix::times(const Eigen::VectorXd& x) const
{
    Eigen::VectorXd product = elastic.selfadjointView<Eigen::Lower>() * x;
    if (turn.cols() > 0) {
        const Eigen::VectorXd shares = stiffness_scale * (turn.transpose() * x);
        product -= turn.leftCols<3>() * shares.tail<3>() + turn.rightCols<3>() * shares.head<3>();
    }
    return product;
}

WholeAssembly::WholeAssembly(const ElasticMesh& mesh, const Eigen::SparseMatrix<double>& mass_matrix,
                             std::vector<char> fixed, bool keeps)
    : fixed_(std::move(fixed)), keeps_(keeps), assembly_(mesh)
{
    std::vector<char> known = fixed_;  // a fixed control point is zero, whatever its edge does
    std::vector<Eigen::Triplet<double>> entries;
    for (const ElasticElement& element : mesh.elements())
        for (int i = 4; i < nodes_of(mesh.basis()); ++i)
            if (const int middle = element.nodes[i]; !std::exchange(known[middle], 1)) {
                const auto& [a, b] = tetrahedron_edges[i - 4];
                edges_.push_back({middle, {element.nodes[a], element.nodes[b]}});
                entries.emplace_back(middle, middle, 1);
                for (const int end : edges_.back().ends)
                    entries.emplace_back(middle, end, -0.5);
            }
    for (int node = 0; node < mesh.node_count(); ++node)
        entries.emplace_back(node, node, 1);
    Eigen::SparseMatrix<double> coefficients(mesh.node_count(), mesh.node_count());
    coefficients.setFromTriplets(entries.begin(), entries.end());
    mass_matrix_ = Eigen::SparseMatrix<double>(coefficients.transpose()) *
                   Eigen::SparseMatrix<double>(mass_matrix * coefficients);
}

/// An element's part of K for values at its nodes.
Eigen::MatrixXd WholeAssembly::at_nodes(const Elasticity& elasticity, int element) const
{
    Eigen::MatrixXd stiffness = elasticity.stiffness_of(element);
    const ElasticMesh& mesh = elasticity.mesh();
    for (int i = 4; i < nodes_of(mesh.basis()); ++i) {
        if (fixed_[mesh.elements()[element].nodes[i]])
            continue;
        for (const int end : tetrahedron_edges[i - 4]) {
            stiffness.middleCols<3>(3 * end) -= 0.5 * stiffness.middleCols<3>(3 * i);
            stiffness.middleRows<3>(3 * end) -= 0.5 * stiffness.middleRows<3>(3 * i);
        }
        stiffness.middleCols<3>(3 * i) *= 2;
        stiffness.middleRows<3>(3 * i) *= 2;
    }
    return stiffness;
}

/// What forces on coefficients are for values at the nodes.
Eigen::VectorXd WholeAssembly::at_nodes(NodalVectors forces) const
{
    for (const auto& [middle, ends] : edges_) {
        for (const int end : ends)
            forces.col(end) -= 0.5 * forces.col(middle);
        forces.col(middle) *= 2;
    }
    for (Eigen::Index node = 0; node < forces.cols(); ++node)
        if (fixed_[node])
            forces.col(node).setZero();
    return as_vector(forces);
}

NodalVectors WholeAssembly::values(NodalVectors coefficients) const
{
    for (const auto& [middle, ends] : edges_)
        coefficients.col(middle) = 0.5 * coefficients.col(middle) +
                                   0.25 * (coefficients.col(ends[0]) + coefficients.col(ends[1]));
    return coefficients;
}

NodalVectors WholeAssembly::on_coefficients(NodalVectors impulses) const
{
    for (const auto& [middle, ends] : edges_) {
        for (const int end : ends)
            impulses.col(end) += 0.25 * impulses.col(middle);
        impulses.col(middle) *= 0.5;
    }
    return impulses;
}

//! [assemble_whole]
WholeMatrix WholeAssembly::assemble(const Elasticity& elasticity, const WholeTurn* turn, double mass_scale,
                                    double stiffness_scale)
{
    if (keeps_ && kept_.empty())
        for (std::size_t e = 0; e < elasticity.mesh().elements().size(); ++e)
            kept_.push_back(at_nodes(elasticity, static_cast<int>(e)));
    const auto stiffness_of = [&](int e) { return keeps_ ? kept_[e] : at_nodes(elasticity, e); };
    WholeMatrix whole;
    whole.elastic = assembly_.assemble(elasticity, mass_matrix_, fixed_, mass_scale, stiffness_scale,
                                       stiffness_of);
    whole.stiffness_scale = stiffness_scale;
    const Eigen::RowVectorXd masses = mass_matrix_.diagonal().transpose();
    whole.masses = masses.replicate<3, 1>().reshaped();
    if (!turn)
        return whole;
    // P^T K P with P = 1 - T G^T, which takes out a turn, is K - G U^T - U G^T with U = K T - G T^T K T / 2
    Eigen::MatrixXd g(whole.size(), 3), kt(whole.size(), 3), t(whole.size(), 3);
    for (int axis = 0; axis < 3; ++axis) {
        const NodalVectors field = turn->turn_about(axis);
        NodalVectors forces = NodalVectors::Zero(3, field.cols());
        elasticity.add_stiffness_times(field, 1, forces);
        t.col(axis) = as_vector(values(field));
        kt.col(axis) = at_nodes(std::move(forces));
        g.col(axis) = at_nodes(turn->share_of_turn(axis));
    }
    whole.turn.resize(whole.size(), 6);
    whole.turn << g, kt - 0.5 * g * (t.transpose() * kt);
    return whole;
}
//! [assemble_whole]

}  // namespace enduring
