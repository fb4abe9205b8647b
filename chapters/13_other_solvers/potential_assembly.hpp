#pragma once

#include "chapters/13_other_solvers/barrier_terms.hpp"

#include <Eigen/SparseCore>

#include <vector>

namespace enduring {

/// Where the coordinates of a step lie in one vector: six of each rigid body, its displacement and a rotation
/// vector, and three of each node.
struct StepCoordinates {
    explicit StepCoordinates(const MethodStep& step);

    int count = 0;
    std::vector<int> of_body, of_node;  ///< the first one; -1 for what does not move

    /// Places behind a displacement of all coordinates.
    Places moved(const Places& from, const Eigen::VectorXd& by) const;
};

//! [potential_slopes]
/// Gradient and Hessian of a potential by all coordinates, summed up part by part.
class PotentialSlopes {
public:
    /// @param coordinates  outlive this
    explicit PotentialSlopes(const StepCoordinates& coordinates)
        : coordinates_(coordinates), gradient_(Eigen::VectorXd::Zero(coordinates.count))
    {}

    /// What depends on the corners of a pair.
    /// @param of  by the corners; of its Hessian by the coordinates the positive part counts
    void add_pair(const ContactPoint& pair, const Places& places, const Derivatives& of);
    /// What depends on four nodes, with a Hessian without negative part.
    void add_nodes(const std::array<std::size_t, 4>& nodes, const Derivatives& of);
    /// A block on the diagonal, at the first coordinate of a body or a node.
    void add_block(int first, const Eigen::Ref<const Eigen::VectorXd>& slope,
                   const Eigen::Ref<const Eigen::MatrixXd>& bend);

    const Eigen::VectorXd& gradient() const { return gradient_; }
    Eigen::SparseMatrix<double> hessian() const;

private:
    void add(const std::vector<int>& at, const Eigen::VectorXd& slope, const Eigen::MatrixXd& bend);

    const StepCoordinates& coordinates_;
    Eigen::VectorXd gradient_;
    std::vector<Eigen::Triplet<double>> entries_;
};
//! [potential_slopes]

}  // namespace enduring
