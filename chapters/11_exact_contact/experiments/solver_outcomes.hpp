#pragma once

#include "chapters/11_exact_contact/experiments/siconos_scores.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "common/experiments/report/table.hpp"

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace enduring::chapter11 {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// What a solver makes of a problem, asked for a part of a threshold.
struct Outcome {
    double error = never, seconds = never;
};
/// By solver, "ours" or one of siconos_solvers; a place for each problem.
using Outcomes = std::map<std::string, std::vector<Outcome>>;

/// Ours and, where it is installed, those of Siconos.
/// @param threshold  of the natural map; all are asked for a tenth of it, for each measures its error in
///     another way
Outcomes outcomes_for(const std::vector<NamedProblem>& problems, double threshold);

/// Problems under one name.
using NamedSet = std::pair<std::string, std::vector<NamedProblem>>;

/// A row for each set: how many of its problems in three dimensions ours and Siconos' solvers bring to 1e-8,
/// and our time over theirs.
Table scores_of(const std::vector<NamedSet>& sets);

/// The answer to a problem; one with an infinite error where it needs more memory than there is.
ExactSolution solution_of(const FrictionProblem& problem, const ExactSettings& settings = {});

}  // namespace enduring::chapter11
