#pragma once

#include "chapters/11_exact_contact/friction_problem.hpp"

#include <vector>

namespace enduring {

/// How near to exact contact, and with how much work.
struct ExactSettings {
    /// h = k dt^2 / m of the springs in the first pass. Others follow where passes bring little, and those of
    /// `other_h` where they bring nothing, so what is solved does not depend on it.
    double h = 1e6;
    /// All passes have this h, whatever they bring: to measure springs.
    bool keeps_h = false;
    /// Begins with Gauss-Seidel over contacts (sweep_contacts()) as long as it is worth it. Where a quarter
    /// of all passes and steps does not solve the problem from there, passes begin once more from nothing.
    /// Not where all passes keep their h.
    bool sweeps = true;
    /// of the natural map; the collections count 1e-8 as solved
    double tolerance = 1e-9;
    /// Of Newton's method in a pass: one that needs more has springs that are too stiff.
    int max_steps_of_pass = 100;
    /// The same over all passes. Nearly all problems of the collections need less than 100, and a jam of 463
    /// contacts 3,570. Half: the jam ends at an error of 1.4e-8.
    int max_newton_steps = 4000;
    /// of all these steps, counted as operations_of_newton_step(): about two minutes. Only problems of some
    /// thousand contacts reach it.
    double max_operations = 2e11;
    int max_passes = 200;
    /// So many passes that bring nothing, and the problem is begun again from the best answer with another h.
    /// Passes may lead away from a place where they stand before they bring anything: with six, four of the
    /// 54 generated problems end unsolved.
    int max_idle_passes = 20;
};

/// Springs are no softer and no stiffer than this h. Softer: a pass brings less than a hundredth of what is
/// missing. Stiffer: rounding of W is more than the springs give.
inline constexpr double softest_h = 1e-2, stiffest_h = 1e12;

/// The length of all contacts' natural maps over the length of q from which on a problem counts as solved.
inline constexpr double solved_error = 1e-8;

struct ExactSolution {
    Eigen::VectorXd impulses;    ///< r of the best pass, as the problem has it
    double error = 0;            ///< of the natural map
    int sweeps = 0;              ///< before the passes
    std::vector<double> errors;  ///< after each pass; without sweeps the first one is that of springs alone
    std::vector<int> steps;      ///< of Newton's method, in each pass
    int newton_steps = 0;
    bool solved() const { return error <= solved_error; }
};

/// Springs that remember: what each contact's spring pushed in one pass is what it begins the next one with.
/// So it pushes the same without being pressed any further. Where no pass changes an impulse any more, no
/// spring gives: contact is exact, however soft k. This is the method of multipliers: M. R. Hestenes:
/// Multiplier and gradient methods, Journal of Optimization Theory and Applications 4, 1969; P. Alart, A.
/// Curnier: A mixed formulation for frictional contact problems prone to Newton like solution methods,
/// Computer Methods in Applied Mechanics and Engineering 92, 1991.
///
/// A pass that takes little of the error has springs that give too much, and the next ones are ten times
/// stiffer; one that was not solved has springs that are too stiff, and the next ones are softer.
ExactSolution solve_exactly(const FrictionProblem& problem, const ExactSettings& settings = {});

}  // namespace enduring
