#pragma once

#include <Eigen/Core>

#include <vector>

namespace enduring {

/// Speeds up the rounds x -> g(x) that look for x = g(x): from the last rounds it finds the combination whose
/// error g(x) - x, as far as it is linear, is least, and goes on from there.
///
/// D. G. Anderson: Iterative procedures for nonlinear integral equations, Journal of the ACM 12, 1965. Where
/// g is linear this is GMRES (Walker and Ni 2011).
class AndersonMixing {
public:
    /// @param rounds  at most so many changes from round to round are combined; with 0, nothing is mixed
    explicit AndersonMixing(int rounds) : rounds_(static_cast<std::size_t>(rounds)) {}

    /// @param x      of this round
    /// @param image  g(x)
    /// @return       x of the next round
    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& image);

private:
    std::size_t rounds_;
    Eigen::VectorXd last_image_, last_error_;
    std::vector<Eigen::VectorXd> images_, errors_;  ///< how both changed from one round to the next
};

}  // namespace enduring
