#pragma once

#include "chapters/07_implicit_contact/contact_problem.hpp"

namespace enduring {

/// Looks for the limits of friction that their own answer makes. A convex problem with limits has an answer,
/// and its normal impulses are other limits; the error is what lies between. From one round to the next an
/// error changes by a factor: negative and large where bodies jam, sometimes just above 1. The secant through
/// two rounds says which part of the error to take: in a jam less than all, near 1 more.
///
/// A. C. Aitken: On Bernoulli's numerical solution of algebraic equations, Proceedings of the Royal Society
/// of Edinburgh 46, 1926, with one number for all pairs.
class LimitSearch {
public:
    /// Sets the limits of the next round.
    /// @param problem  with the limits of this round
    /// @param change   its answer
    void advance(ContactProblem& problem, const Eigen::VectorXd& change);

private:
    Eigen::VectorXd last_error_;
    double part_ = 1;  ///< of the error that a round takes
};

/// The problem of a round with the limits of friction that its own answer makes: convex problems, one after
/// the other, whose limits a search brings nearer.
/// @param problem     its rows hold the limits to begin with
/// @param tolerance   of the true residual
/// @param max_steps  of Newton's method, over all convex problems, each of which counts as one more
ProblemSolution solve_with_limit_search(ContactProblem problem, NewtonMatrix& matrix,
                                        const ProblemSolution& begin, double tolerance, double least_speed,
                                        int max_steps);

}  // namespace enduring
