#include "exercises/07_implicit_contact/2_row_sums.hpp"

#include <algorithm>

namespace enduring {

// From its definition: W = J M^-1 J^T, with J the matrix that takes velocities of cubes to those of joints.
Eigen::MatrixXd delassus_of_pile(const std::vector<double>& masses)
{
    const auto count = static_cast<Eigen::Index>(masses.size());
    const Eigen::VectorXd inverse = Eigen::Map<const Eigen::VectorXd>(masses.data(), count).cwiseInverse();
    Eigen::MatrixXd opening = Eigen::MatrixXd::Identity(count, count);
    for (Eigen::Index i = 1; i < count; ++i)
        opening(i, i - 1) = -1;
    return opening * inverse.asDiagonal() * opening.transpose();
}

Eigen::VectorXd row_sums(const Eigen::MatrixXd& delassus)
{
    Eigen::VectorXd sums(delassus.rows());
    for (Eigen::Index i = 0; i < delassus.rows(); ++i)
        sums(i) = delassus.row(i).lpNorm<1>();
    return sums;
}

Eigen::VectorXd answered_at_once(const Eigen::MatrixXd& delassus, const Eigen::VectorXd& free,
                                 const Eigen::VectorXd& divisors, const Eigen::VectorXd& impulses)
{
    Eigen::VectorXd result(free.size());
    for (Eigen::Index i = 0; i < free.size(); ++i)
        result(i) = std::max(0.0, impulses(i) - (free(i) + delassus.row(i).dot(impulses)) / divisors(i));
    return result;
}

int rounds_until_answered(const Eigen::MatrixXd& delassus, const Eigen::VectorXd& free,
                          const Eigen::VectorXd& divisors, double tolerance, int most)
{
    Eigen::VectorXd impulses = Eigen::VectorXd::Zero(free.size());
    int rounds = 0;
    const auto open = [&] {
        const Eigen::VectorXd velocity = free + delassus * impulses;
        return ((impulses.array() > 0).select(velocity.array().abs(), -velocity.array()) >= tolerance).any();
    };
    while (rounds < most && open()) {
        impulses = answered_at_once(delassus, free, divisors, impulses);
        ++rounds;
    }
    return rounds;
}

}  // namespace enduring
