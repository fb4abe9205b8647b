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
    /// @param x      of this round
    /// @param image  g(x)
    /// @return       x of the next round
    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& image);

private:
    static constexpr std::size_t max_rounds = 8;  ///< that it looks back

    Eigen::VectorXd last_image_, last_error_;
    std::vector<Eigen::VectorXd> images_, errors_;  ///< how both changed from one round to the next
};

}  // namespace enduring
