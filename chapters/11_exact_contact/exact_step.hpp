#pragma once

#include "common/simulation/step.hpp"

#include <functional>

namespace enduring {

/// How a step of a scene came near to exact contact.
struct PassRecord {
    int step = 0;
    int passes = 0;
    /// how far the last pass moved a spring whose force it did not change any more, over the length of its
    /// pair [1]; the largest
    double moved = 0;
    bool reached = true;  ///< the tolerance
};

/// Says on the standard error stream which step has taken all passes that there are, and what they left.
void tell_unfinished_passes(const PassRecord& record);

//! [settings]
/// How near to exact contact a step of a scene is brought, and with how much work.
struct ExactStepSettings {
    /// of the length of a pair: how far a pass may still press or stretch a spring [1]; what is left is
    /// forgotten in each step, so a stack may drift by as much in a step. A tenth: passes ask for what the
    /// solve's own tolerance leaves. A hundred times: ten cubes drift by micrometres a second.
    double tolerance = 1e-9;
    /// Of a response. A tenth: the memory from step to step has to do all the work, and stacks land by
    /// springs. Ten times: jams, whose forces are not determined, take ten times as long.
    int max_passes = 10;
    std::function<void(const PassRecord&)> record = tell_unfinished_passes;
};
//! [settings]

/// The passes of one response: `solve` finds the impulses of all pairs on springs; then each spring begins
/// pressed in by what it pushed, and it is solved again, until no spring is moved any more. From step to step
/// the force is remembered as the pair's load. Where a pair began inside, its spring keeps the rest offset
/// with which it separates: that is no force.
void solve_in_passes(const Pass::Function& solve, World& world, Contacts& contacts, double dt,
                     const ExactStepSettings& settings);

/// At the end of a step: a rest offset holds no force any more, for the load holds it, too; it is the depth
/// that the step has left, from which the next one goes on. Springs that remember hold no energy, so the
/// step's budget gets back what their loads would be on springs.
void leave_force_to_load(World& world, Contacts& contacts);

}  // namespace enduring
