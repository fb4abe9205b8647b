#include "chapters/13_other_solvers/potential_assembly.hpp"

#include <Eigen/Eigenvalues>

#include <utility>

namespace enduring {

StepCoordinates::StepCoordinates(const MethodStep& step)
{
    for (const MovingBody& body : step.bodies)
        of_body.push_back(body.moves ? std::exchange(count, count + 6) : -1);
    for (const SoftNode& node : step.nodes)
        of_node.push_back(node.inverse_mass > 0 ? std::exchange(count, count + 3) : -1);
}

Places StepCoordinates::moved(const Places& from, const Eigen::VectorXd& by) const
{
    Places to = from;
    for (std::size_t i = 0; i < of_body.size(); ++i)
        if (of_body[i] >= 0) {
            const Vec3 turn = by.segment<3>(of_body[i] + 3);
            const Eigen::AngleAxisd about(turn.norm(), turn.stableNormalized());
            to.poses[i] = {from.poses[i].position + by.segment<3>(of_body[i]),
                           (about * from.poses[i].orientation).normalized()};
        }
    for (std::size_t n = 0; n < of_node.size(); ++n)
        if (of_node[n] >= 0)
            to.nodes[n] += by.segment<3>(of_node[n]);
    return to;
}

namespace {

Mat3 cross_matrix(const Vec3& r)
{
    return (Mat3() << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0).finished();
}

Eigen::MatrixXd positive_part(const Eigen::MatrixXd& matrix)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> own(matrix);
    return own.eigenvectors() * own.eigenvalues().cwiseMax(0).asDiagonal() * own.eigenvectors().transpose();
}

/// Appends coordinates `first`, ... to those of a pair, unless it does not move. @return  their place among
/// those of the pair, or -1
int append(int first, int count, std::vector<int>& at)
{
    if (first < 0)
        return -1;
    for (int k = 0; k < count; ++k)
        at.push_back(first + k);
    return static_cast<int>(at.size()) - count;
}

}  // namespace

void PotentialSlopes::add(const std::vector<int>& at, const Eigen::VectorXd& slope,
                          const Eigen::MatrixXd& bend)
{
    for (int i = 0; i < static_cast<int>(at.size()); ++i) {
        const int row = at[static_cast<std::size_t>(i)];
        if (row < 0)
            continue;
        gradient_[row] += slope[i];
        for (int j = 0; j < static_cast<int>(at.size()); ++j)
            if (at[static_cast<std::size_t>(j)] >= 0)
                entries_.emplace_back(row, at[static_cast<std::size_t>(j)], bend(i, j));
    }
}

void PotentialSlopes::add_block(int first, const Eigen::Ref<const Eigen::VectorXd>& slope,
                                const Eigen::Ref<const Eigen::MatrixXd>& bend)
{
    std::vector<int> at;
    append(first, static_cast<int>(slope.size()), at);
    add(at, slope, bend);
}

void PotentialSlopes::add_nodes(const std::array<std::size_t, 4>& nodes, const Derivatives& of)
{
    std::vector<int> at;
    for (const std::size_t node : nodes)
        for (int k = 0; k < 3; ++k)
            at.push_back(coordinates_.of_node[node] < 0 ? -1 : coordinates_.of_node[node] + k);
    add(at, of.gradient, of.hessian);
}

//! [add_pair]
/// A node is a corner itself. A corner of a rigid body moves by dx - r x dw, and its second derivative by the
/// rotation vector is that of the exponential map.
void PotentialSlopes::add_pair(const ContactPoint& pair, const Places& places, const Derivatives& of)
{
    const FourPoints x = corners_of(pair, places);
    std::vector<int> at;
    std::array<int, 2> sides{-1, -1};  // of rigid bodies
    std::array<int, 4> corners{-1, -1, -1, -1};
    for (int side = 0; side < 2; ++side) {
        const int body = side == 0 ? pair.a : pair.b;
        sides[static_cast<std::size_t>(side)] = append(coordinates_.of_body[static_cast<std::size_t>(body)],
                                                       6, at);
    }
    for (std::size_t i = 0; i < 4; ++i)
        if (pair.nodes[i] >= 0)
            corners[i] = append(coordinates_.of_node[static_cast<std::size_t>(pair.nodes[i])], 3, at);
    const auto count = static_cast<Eigen::Index>(at.size());
    Eigen::MatrixXd rate = Eigen::MatrixXd::Zero(12, count), turned = Eigen::MatrixXd::Zero(count, count);
    for (int i = 0; i < pair.corner_count(); ++i) {
        const auto n = static_cast<std::size_t>(i);
        if (corners[n] >= 0)
            rate.block<3, 3>(3 * i, corners[n]).setIdentity();
        const bool is_a = i < pair.corners_of_a();
        const int side = sides[is_a ? 0 : 1];
        if (pair.nodes[n] >= 0 || side < 0)
            continue;
        const Vec3 r = x[n] - places.poses[static_cast<std::size_t>(is_a ? pair.a : pair.b)].position,
                   f = of.gradient.segment<3>(3 * i);
        rate.block<3, 3>(3 * i, side).setIdentity();
        rate.block<3, 3>(3 * i, side + 3) = -cross_matrix(r);
        turned.block<3, 3>(side + 3, side + 3) += 0.5 * (f * r.transpose() + r * f.transpose()) -
                                                  f.dot(r) * Mat3::Identity();
    }
    add(at, rate.transpose() * of.gradient, positive_part(rate.transpose() * of.hessian * rate + turned));
}
//! [add_pair]

Eigen::SparseMatrix<double> PotentialSlopes::hessian() const
{
    Eigen::SparseMatrix<double> hessian(coordinates_.count, coordinates_.count);
    hessian.setFromTriplets(entries_.begin(), entries_.end());
    return hessian;
}

}  // namespace enduring
