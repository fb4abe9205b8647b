#pragma once

#include "common/experiments/report/report.hpp"

#include <string>
#include <vector>

namespace enduring {

/// Where the time of a run went, by pass. Kept out of all result
/// tables, which must not change from run to run.
class Timings {
public:
    /// Starts the clock: time before it belongs to no pass.
    void start();
    /// The time since the last lap, or since the start, went into this pass.
    void lap(const std::string& pass);
    void add(const std::string& pass, double seconds);

    double total() const;                      ///< of all passes [s]
    double of(const std::string& pass) const;  ///< [s]; 0 for a pass that never ran

    /// pass, calls, seconds, share, ms_per_step: a row a pass in the order of their first
    /// run, then "total". The last row, "real-time factor", has in `seconds` the
    /// simulated time and in `share` simulated over computed time.
    Table table(double simulated_seconds, int steps) const;

private:
    struct Row {
        std::string pass;
        long calls = 0;
        double seconds = 0;
    };
    std::vector<Row> rows_;
    double last_ = 0;  ///< when the clock was last looked at [s]
};

}  // namespace enduring
