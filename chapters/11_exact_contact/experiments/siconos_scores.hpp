#pragma once

#include "chapters/11_exact_contact/experiments/problem_folder.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace enduring::chapter11 {

/// What a solver of Siconos makes of a problem.
struct SiconosAnswer {
    std::string solver;        ///< one of siconos_solvers
    std::size_t problem;       ///< its place among those that were given
    double seconds;            ///< of processor time, without reading
    Eigen::VectorXd impulses;  ///< r
};

/// Gauss-Seidel over contacts, Newton's method on all of them, and the method of alternating directions.
inline const std::vector<std::string> siconos_solvers{"NSGS", "Newton", "ADMM"};

/// Solves problems in three dimensions by the script siconos_solvers.py; each is given by its W, in blocks.
/// Nothing where Siconos is not installed.
/// @param tolerance  of the natural map, as Siconos measures it itself
/// @throws std::runtime_error  Siconos is there, and its answers are not, as on a full disk
std::vector<SiconosAnswer> solve_by_siconos(const std::vector<NamedProblem>& problems, double tolerance);

/// Siconos' text with W in blocks of 3 x 3.
std::string blocks_text(const FrictionProblem& problem);

}  // namespace enduring::chapter11
