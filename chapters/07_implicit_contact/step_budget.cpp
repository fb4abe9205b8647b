#include "chapters/07_implicit_contact/step_budget.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

void StepBudget::begin_response(const World& world, const BudgetLimits& limits, int pairs)
{
    if (world.work.attempts == 0 && world.attempt.work.responses == 0)
        used_ = 0;
    times_ = std::clamp(static_cast<double>(limits.pairs) / std::max(1, pairs), 1.0, limits.times);
}

//! [of_island]
Allowance StepBudget::of_island(const World& world, const BudgetLimits& limits, int taken, double dt) const
{
    const auto steps_of = [this](double limit) { return static_cast<int>(times_ * limit); };
    const int of_attempt = steps_of(limits.of_attempt), left = steps_of(limits.of_step - used_),
              steps = std::min(of_attempt, taken + std::max(left, steps_of(limits.of_response)));
    const bool is_short = dt < 1.001 * std::ldexp(world.whole_dt, -limits.halvings);
    return {steps, is_short || !world.attempt.may_be_halved || steps < of_attempt};
}
//! [of_island]

}  // namespace enduring
