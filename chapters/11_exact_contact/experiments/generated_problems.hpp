#pragma once

#include "chapters/11_exact_contact/experiments/problem_folder.hpp"

namespace enduring::chapter11 {

/// Small versions of experiments leave out what has more contacts than this.
inline constexpr int most_quick_contacts = 30;

/// A problem that a rule made, and the rule's name.
struct GeneratedProblem {
    std::string kind;  ///< "tower", "packing", "graph", "dense" or "scaled"
    NamedProblem named;
};

/// 54 problems that nobody has chosen, each given by W alone, the same on every machine:
///   tower    2, 5 or 10 cubes with 4 contacts each, whose masses differ by 1 : 1e4 or 1 : 1e6
///   packing  8, 27 or 64 spheres in a box without a lid, of one mass or of masses from 1 : 1000
///   graph    4, 10 or 25 bodies, contacts between any two of them
///   dense    W of random levers, with less, as many or more ways to move than contacts have numbers
///   scaled   some of these, each contact in units that are a thousand times larger or smaller
/// @param set  0: those on which the solver was tried; any other number: as many of the same rules that
///     nobody has looked at
std::vector<GeneratedProblem> generated_problems(unsigned set = 0);

}  // namespace enduring::chapter11
