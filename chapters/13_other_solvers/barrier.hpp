#pragma once

#include "chapters/13_other_solvers/method_solver.hpp"

namespace enduring {

/// The barrier method for rigid bodies and for soft ones, whose nodes and elements are in the same problem.
/// No body ever touches another: each step minimises the incremental potential, inertia plus elements plus
/// barriers plus lagged friction, by projected Newton's method, and chapter 2's query bounds every step of
/// it.
///
/// Bodies begin where they are drawn, often in touch, and there is no barrier at distance 0. So closed bodies
/// get surfaces for contact that lie half of d^hat inside, as in chapter 8, and a plane lies as much below:
/// in touch, they are d^hat apart. A soft body keeps its own surface: in touch with a rigid one or a plane it
/// is half of d^hat away, and with another soft one it is refused. A step that turns a body by more than half
/// a radian, gains energy or ends unsolved is taken in halves, as in chapter 8. It serves one world, so make
/// one for each run.
class BarrierMethod {
public:
    explicit BarrierMethod(const BarrierSettings& settings) : settings_(settings) {}
    /// All pairs of features that can meet while no vertex moves farther than reach() in the step.
    /// @throws InputError  two bodies begin inside each other, a body begins behind a plane, or a body moves
    ///     as given; names it
    Contacts find(World& world);
    /// @param step  changed in place
    void operator()(MethodStep& step) const;

private:
    void begin(World& world);

    BarrierSettings settings_;
    CandidateSearch search_;
    double size_ = 0;      ///< of the smallest moving body [m]; 0 before the first step
    double reach_ = 0;     ///< [m]
    double whole_dt_ = 0;  ///< of the step of which this one may be a part [s]
};

Solver chapter13_barrier_solver(const ContactParameters& parameters, const BarrierSettings& settings = {});

}  // namespace enduring
