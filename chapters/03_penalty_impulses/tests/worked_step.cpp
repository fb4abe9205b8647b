#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/worked_step/tests/worked_step_numbers.hpp"

using namespace enduring;

namespace {

/// This chapter's own passes; only the redefinition, which chapter 6 brings, is still the page's stand-in.
Solver real_solver(double stiffness)
{
    ContactParameters parameters;
    parameters.stiffness = stiffness;
    Solver solver = chapter03_solver(parameters);
    solver.append(StepStage::refresh, stand_in_redefine());
    return solver;
}

}  // namespace

TEST_CASE("worked step: detection, resolution and impulses of this chapter give the page's numbers")
{
    tests::check_worked_step(real_solver(worked_step().stiffness));
}
