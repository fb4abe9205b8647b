#pragma once

#include "chapters/07_implicit_contact/islands.hpp"

namespace enduring {

//! [budget]
/// How many steps of Newton's method a step may take for rigid bodies without joints. Where they end, the
/// step is not given up: the problem of the last round is solved to its end, which takes energy only.
struct BudgetLimits {
    /// Of an island in one attempt, with its rounds. A tenth: steps are halved that a few rounds more would
    /// solve. Ten times: half of the work goes into attempts that are thrown away.
    int of_attempt = 100;
    /// Of all islands, each by its part of the pairs, in all attempts at a step and at its parts. A tenth: in
    /// a hit, friction has the limits of the last round. Ten times: a wall that is hit takes ten times as
    /// long.
    int of_step = 300;
    /// Of an island in a response when the step's are used up. A tenth: what a pair has not carried before
    /// has no friction. Ten times: a wall that is hit takes three times as long.
    int of_response = 10;
    /// Of the problem that is solved to its end. A tenth: large islands stop before it. Ten times: the same,
    /// for 12 are enough for 100 pairs.
    int of_last_problem = 60;
    /// With fewer pairs a step costs little, so it may take more: as many times as there are less, at most
    /// `times`. A tenth: a ball that lands while it slides ends 4 % too slow. Ten times: a wall that is hit
    /// takes twice as long.
    int pairs = 200;
    /// At most so many times. A tenth: as for `pairs`. Ten times: what has no answer is asked for it ten
    /// times as long.
    double times = 5;
    /// How often a step is halved because it is not solved. None: friction errs in whole steps. Five: a hit
    /// is taken in 32 parts that are not solved either.
    int halvings = 2;
};
//! [budget]

/// What an island may take in a response.
struct Allowance {
    int newton_steps;  ///< since the attempt began
    bool is_last;      ///< what is not solved with them is not tried again in halves
};

/// Counts what the islands of a step have taken. It forgets everything when the next step begins, and islands
/// are counted in their order, so it is the same for any number of threads and after a run was resumed.
class StepBudget {
public:
    /// Ready for a response; the first one of a step begins at zero.
    /// @param pairs  of all islands
    void begin_response(const World& world, const BudgetLimits& limits, int pairs);

    /// @param taken  by this island in this attempt
    Allowance of_island(const World& world, const BudgetLimits& limits, int taken, double dt) const;

    /// @param part  of all pairs of the response that the island has, in [0, 1]
    void take(int newton_steps, double part) { used_ += newton_steps * part / times_; }

private:
    double used_ = 0;   ///< steps of Newton's method with many pairs
    double times_ = 1;  ///< as many may be taken with the pairs that there are
};

}  // namespace enduring
