#include "exercises/07_implicit_contact/2_row_sums.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>

namespace enduring {

Eigen::MatrixXd delassus_of_pile(const std::vector<double>& masses)
{
    not_implemented_yet("7.2");
}

Eigen::VectorXd row_sums(const Eigen::MatrixXd& delassus)
{
    not_implemented_yet("7.2");
}

Eigen::VectorXd answered_at_once(const Eigen::MatrixXd& delassus, const Eigen::VectorXd& free,
                                 const Eigen::VectorXd& divisors, const Eigen::VectorXd& impulses)
{
    not_implemented_yet("7.2");
}

int rounds_until_answered(const Eigen::MatrixXd& delassus, const Eigen::VectorXd& free,
                          const Eigen::VectorXd& divisors, double tolerance, int most)
{
    not_implemented_yet("7.2");
}

}  // namespace enduring
