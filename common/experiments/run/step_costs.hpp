#pragma once

#include "common/experiments/run/probes.hpp"

namespace enduring {

/// What each step cost, in counts (StepWork): a row a step. The state before the first step is no row.
///
/// time_s (at its end), pairs (alive then), the numbers of visit_work(), inverted_elements (at its end, of
/// all bodies).
class StepCosts final : public TableProbe {
public:
    StepCosts();
    void observe(const World& world, const Contacts& contacts, double dt) override;

    /// A column's numbers, a step each.
    std::vector<double> column(const std::string& name) const;

private:
    bool began_ = false;
};

/// Where the time of each step went: what all threads of this program had of their processors. Kept out of
/// all comparisons, since it changes from run to run.
///
/// time_s, search_ms (passes before the first detection), query_ms (detection), solve_ms (responses, elastic
/// forces, restitution), rest_ms (prediction, commit).
class StepTimes final : public TableProbe {
public:
    explicit StepTimes(const Solver& solver);
    /// A step begins: what went before belongs to no step.
    void begin();
    /// A pass is done.
    void lap(const std::string& pass);
    void observe(const World& world, const Contacts& contacts, double dt) override;

    std::vector<double> totals() const;  ///< of each step [ms]

private:
    enum Kind : std::size_t { search, query, solve, rest, kinds };

    std::vector<std::pair<std::string, Kind>> kind_of_;  ///< of the solver's passes
    std::array<double, kinds> spent_{};                  ///< in this step [s]
    double last_ = 0;                                    ///< when the clock was last looked at [s]
    bool runs_ = false;
};

/// "MEAN UNIT in the mean, VALUE in 99 % of them, VALUE at most (step N)": of one number a step; at least one
/// step.
/// @param first  number of the first step
std::string mean_and_worst(const std::vector<double>& of_step, const std::string& unit, int first);

}  // namespace enduring
