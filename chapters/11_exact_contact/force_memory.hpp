#pragma once

#include "chapters/07_implicit_contact/contact_problem.hpp"
#include "chapters/11_exact_contact/friction_problem.hpp"

#include <vector>

namespace enduring {

/// How near to exact contact, and with how much work.
struct ExactSettings {
    /// h = k dt^2 / m of the springs in the first pass. Where passes bring little, the next ones have another; so a hundredth or a
    /// hundred times end with the same error, after up to twice as many steps.
    double h = 1e6;
    /// All passes have this h, whatever they bring: to measure springs.
    bool keeps_h = false;
    /// of the natural map; the collections count 1e-8 as solved
    double tolerance = 1e-9;
    /// Of a pass' solve, at first; a tenth of it where a pass did not take 70 % of the error. A thousandth: the first passes
    /// take many steps for what the next ones change anyway.
    double first_residual = 1e-3;
    /// Of Newton's method in a pass: a jam ends so, and the next pass goes on from there.
    int max_steps_of_pass = 100;
    /// The same over all passes. Nearly all problems of the collections need less than 500.
    int max_newton_steps = 1000;
    int max_passes = 60;
    /// So many passes without half of the best error mean that rounding or a jam is left.
    int max_idle_passes = 8;
};

/// The stiffest h with which a problem is begun: a spring's impulse is k times a motion, so rounding leaves h times 2e-16 of it. A
/// tenth: more passes. A hundred times: the first passes end above 1e-8, and the springs have to become softer.
inline constexpr double stiffest_h = 4e6;

/// The length of all contacts' natural maps over the length of q from which on a problem counts as solved.
inline constexpr double solved_error = 1e-8;

struct ExactSolution {
    Eigen::VectorXd impulses;    ///< r of the best pass, as the problem has it
    double error = 0;            ///< of the natural map
    std::vector<double> errors;  ///< after each pass; the first one is that of springs alone
    std::vector<int> steps;      ///< of Newton's method, in each pass
    int newton_steps = 0;
    bool solved() const { return error <= solved_error; }
};

/// Springs that remember: what each pair's spring pushed in one solve becomes how far it is pressed when the next one begins.
/// So it pushes the same without being pressed any further (`depth_t0` = -r_n / (k dt), `stretch` = -r_t / (k dt)). Where no
/// pass changes an impulse any more, no spring gives: contact is exact, however soft k. This is the method of multipliers:
/// M. R. Hestenes: Multiplier and gradient methods, Journal of Optimization Theory and Applications 4, 1969; P. Alart, A.
/// Curnier: A mixed formulation for frictional contact problems prone to Newton like solution methods, Computer Methods in
/// Applied Mechanics and Engineering 92, 1991.
/// @param impulses  r, three numbers for each pair [N s]
void remember_impulses(ContactProblem& springs, const Eigen::VectorXd& impulses);

/// One solve after the other, each with what the last one found, until the tolerance is reached or passes bring no more. Where a pass
/// brings little, there are two causes: springs that give too much, or a solve that did not reach its residual. It cannot where rounding is larger,
/// and where bodies jam: then limits of friction come back enlarged by springs that are stiff. So the next springs are ten times stiffer, or softer.
ExactSolution solve_exactly(const FrictionProblem& problem, const ExactSettings& settings = {});

}  // namespace enduring
