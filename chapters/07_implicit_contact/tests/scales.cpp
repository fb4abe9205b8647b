#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/motivating_scenes/scaled_scene.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

Solver quiet_solver(const ContactParameters& parameters)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    return chapter07_solver(parameters, settings);
}

}  // namespace

TEST_CASE("scales: a scene moves alike in millimetres, metres and hundreds of metres, and with any density")
{
    for (const motivating::ScaleTrial& trial : motivating::scale_trials()) {
        CAPTURE(trial.name);
        CHECK(motivating::difference_over_scales(trial, quiet_solver) < 1e-8);
    }
}
