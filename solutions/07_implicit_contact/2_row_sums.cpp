#include "exercises/07_implicit_contact/2_row_sums.hpp"

#include <cmath>

namespace enduring {

Eigen::MatrixXd delassus_of_pile(const std::vector<double>& masses)
{
    const auto count = static_cast<Eigen::Index>(masses.size());
    Eigen::MatrixXd delassus = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double answer = 1 / masses[static_cast<std::size_t>(i)];
        delassus(i, i) += answer;
        if (i + 1 < count) {
            delassus(i + 1, i + 1) += answer;
            delassus(i, i + 1) = -answer;
            delassus(i + 1, i) = -answer;
        }
    }
    return delassus;
}

Eigen::VectorXd row_sums(const Eigen::MatrixXd& delassus) { return delassus.cwiseAbs().rowwise().sum(); }

Eigen::VectorXd answered_at_once(const Eigen::MatrixXd& delassus, const Eigen::VectorXd& free,
                                 const Eigen::VectorXd& divisors, const Eigen::VectorXd& impulses)
{
    const Eigen::VectorXd velocity = free + delassus * impulses;
    return (impulses - velocity.cwiseQuotient(divisors)).cwiseMax(0);
}

int rounds_until_answered(const Eigen::MatrixXd& delassus, const Eigen::VectorXd& free,
                          const Eigen::VectorXd& divisors, double tolerance, int most)
{
    Eigen::VectorXd impulses = Eigen::VectorXd::Zero(free.size());
    for (int round = 0; round < most; ++round) {
        const Eigen::VectorXd velocity = free + delassus * impulses;
        bool answered = true;
        for (Eigen::Index i = 0; i < velocity.size(); ++i) {
            const double wrong = impulses(i) > 0 ? std::abs(velocity(i)) : -velocity(i);
            if (wrong >= tolerance)
                answered = false;
        }
        if (answered)
            return round;
        impulses = answered_at_once(delassus, free, divisors, impulses);
    }
    return most;
}

}  // namespace enduring
