#pragma once

#include "chapters/11_exact_contact/friction_problem.hpp"
#include "common/geometry/vector.hpp"

namespace enduring {

/// The masses that contacts feel, one for each number of r: 1 / W_nn along the normal, and 1 over the mean of
/// both along the surface. All springs, and all measures of a pass, are counted in them. So no answer depends
/// on the units of a problem, nor on how heavy one body is beside another.
Eigen::VectorXd felt_masses(const FrictionProblem& problem);

/// Springs that begin a step of 1 s with impulses r_k that they remember. Each has k = h times the mass that
/// its contact feels, and the pass asks for the impulses r with
///   r = push(r - rho m (W r + q + C (r - r_k))),   C = 1 / (h m).
/// W has no inverse in it, so W may be singular. The answer does not depend on rho, and at rho = h it is read
/// as springs: r = push(r_k - k (W r + q)). P. Alart, A. Curnier: A mixed formulation for frictional contact
/// problems prone to Newton like solution methods, Computer Methods in Applied Mechanics and Engineering 92,
/// 1991.
struct SpringPass {
    const FrictionProblem& problem;
    Eigen::VectorXd masses;  ///< felt_masses()
    double h;                ///< k dt^2 / m
    Eigen::VectorXd begin;   ///< r_k
};

/// What a contact pushes where its spring wishes this: nothing along the normal that pulls, and along the
/// surface at most mu times what it pushes along the normal. The first number is along the normal.
Vec3 push(const Vec3& wish, double mu);

/// The slope of push().
Mat3 push_slope(const Vec3& wish, double mu);

struct PassAnswer {
    Eigen::VectorXd impulses;  ///< r
    int newton_steps = 0;
    bool reached = false;  ///< the equation's error is a ten-thousandth of that at the beginning, or rounding
};

/// Newton's method with a line search. Where it stands still it goes on with another rho: the answer is the
/// same, and what stands still differs.
PassAnswer solve_pass(const SpringPass& pass, int max_steps);

}  // namespace enduring
