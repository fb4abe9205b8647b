#pragma once

#include "chapters/11_exact_contact/friction_problem.hpp"

namespace enduring {

/// When sweeps end and passes begin. None of these has a unit.
struct SweepSettings {
    /// Sweeps between two looks at the error: each look costs as much as a sweep.
    int between_looks = 5;
    /// of the steps of Newton's method: sweeps go on while all that are still needed would cost less than so
    /// many. A tenth: sweeps end before they have found which contacts push; ten times: hard problems take
    /// hundreds of sweeps in vain.
    double newton_steps = 10;
    /// of all sweeps: about two minutes. Only problems of some thousand contacts reach it.
    double max_operations = 2e11;
    /// Projections for a contact that slips. One: twice as many sweeps; ten: sweeps cost twice as much.
    int projections = 5;
};

/// About how many operations Newton's method takes for a step of a pass: to factor its matrix, and to set it
/// up.
/// @param unknowns  numbers of r of the contacts that push
double operations_of_newton_step(const FrictionProblem& problem, Eigen::Index unknowns);

struct SweepAnswer {
    Eigen::VectorXd impulses;  ///< r
    double error = 0;          ///< of the natural map
    int sweeps = 0;
};

/// Gauss-Seidel over contacts: one after the other gets the impulse that is exact while all others stay as
/// they are. It needs no factor, so a sweep costs as much as one product W r. Sweeps go on while they bring
/// something, and find which contacts push. M. Jean: The non-smooth contact dynamics method, Computer Methods
/// in Applied Mechanics and Engineering 177, 1999.
/// @param tolerance  of the natural map, at which they end
SweepAnswer sweep_contacts(const FrictionProblem& problem, double tolerance,
                           const SweepSettings& settings = {});

}  // namespace enduring
