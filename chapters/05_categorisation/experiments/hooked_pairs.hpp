#pragma once

#include "chapters/05_categorisation/category.hpp"

namespace enduring::chapter05 {

/// What a solver does with the pairs that are labelled hooked.
enum class HookedPairs {
    pushed,  ///< handled as all others: this chapter's solver
    held,    ///< kept in the list without an impulse
    dropped  ///< removed; the crossing is not looked for again until the features part
};

/// This chapter's solver with another edge rule, and with consequences. For
/// experiments only: neither holding nor dropping is an answer.
Solver solver_that(HookedPairs treatment, EdgeRule rule, const ContactParameters& parameters);

}  // namespace enduring::chapter05
