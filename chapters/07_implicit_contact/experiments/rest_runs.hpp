#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/experiments/render/strip.hpp"
#include "common/experiments/report/growing_table.hpp"

namespace enduring::chapter07 {

/// Runs of scenes that should come to rest: a row each, and for some a picture of the end.
class RestRuns {
public:
    /// @param kept_mm  a body of a building that has gone farther from its start shows that it does not stand
    struct Case {
        std::string name;
        Scene scene;
        double duration;  ///< [s]
        bool pictured = false;
        double kept_mm = 1e9;
        Vec3 seen_from{1, 0.6, 2};  ///< direction to the camera
    };
    /// @param count  of the runs; 0 if nobody knows
    RestRuns(Report& report, const std::string& experiment, MakeSolver make, std::size_t count = 0);
    /// Runs it, and leaves the scene as it ended.
    PileOutcome run(Case& c, Probe* observer = nullptr);
    /// The row of a case that has been run, with its outcome.
    void add(const Case& c, const PileOutcome& outcome);
    /// The table and the facts of an experiment, and its picture: all ends in a grid.
    void report(const std::string& experiment, Report& report, int columns) const;

private:
    MakeSolver make_;
    GrowingTable table_;
    std::vector<StripPicture> ends_;
    PileOutcome worst_;  ///< of the runs that come to rest
    long at_rest_ = 0, unconverged_ = 0, solves_ = 0;
};

/// At rest at the end: over the second half no body has gone faster than 10 µm/s, and no energy has come
/// from nothing.
bool is_at_rest(const PileOutcome& outcome);

}  // namespace enduring::chapter07
