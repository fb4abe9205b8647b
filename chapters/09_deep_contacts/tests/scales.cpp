#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/09_deep_contacts/tests/quiet_solver.hpp"
#include "chapters/motivating_scenes/scaled_scene.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter09;

TEST_CASE("scales: what begins inside a plane or a body separates alike in any size, with any density")
{
    for (const motivating::ScaleTrial& trial : motivating::inside_scale_trials()) {
        CAPTURE(trial.name);
        // Pairs are stiffer than chapter 7's, and rounding moves bodies by as much more. Without weight the
        // most load is what stops the motion alone (max_load()), and runs of two scales part where one of
        // them lets a rest offset fade. With a lever on motion, too, this trial differs by 5e-14, but a cube
        // between two walls is pressed by twice the energy.
        CHECK(motivating::difference_over_scales(trial, quiet_solver) <
              (trial.name == "in a floor, weightless" ? 5e-2 : distance_parts.stiffer * 1e-8));
    }
}

TEST_CASE("scales: what falls, slides, rolls and bends moves alike in any size, with any density")
{
    for (const motivating::ScaleTrial& trial : motivating::scale_trials()) {
        CAPTURE(trial.name);
        // the pairs are ten times as stiff as chapter 7's, so rounding moves them ten times as much
        CHECK(motivating::difference_over_scales(trial, quiet_solver) < 2e-8 * distance_parts.stiffer);
    }
}
