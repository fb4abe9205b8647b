#include "chapters/08_speculative_contacts/search_parts.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "chapters/motivating_scenes/scaled_scene.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

Solver quiet_solver(const ContactParameters& parameters)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    return chapter09_solver(parameters, settings);
}

}  // namespace

TEST_CASE("scales: what begins inside a plane or a body is let out alike in any size, with any density")
{
    for (const motivating::ScaleTrial& trial : motivating::inside_scale_trials()) {
        CAPTURE(trial.name);
        // pairs are ten times as stiff as chapter 7's, so rounding moves bodies ten times as far
        CHECK(motivating::difference_over_scales(trial, quiet_solver) < search_parts.stiffer * 1e-8);
    }
}

TEST_CASE("scales: what falls, slides, rolls and bends moves alike in any size, with any density")
{
    for (const motivating::ScaleTrial& trial : motivating::scale_trials()) {
        CAPTURE(trial.name);
        // the pairs are ten times as stiff as chapter 7's, so rounding moves them ten times as much
        CHECK(motivating::difference_over_scales(trial, quiet_solver) < 1e-8 * search_parts.stiffer);
    }
}
