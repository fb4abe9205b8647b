#include "chapters/08_deep_contacts/solver.hpp"
#include "chapters/motivating_scenes/scaled_scene.hpp"
#include "common/scenes/scene_reader.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using motivating::SceneScale;

namespace {

Scene scene_at(const std::string& scene, const SceneScale& scale)
{
    return read_scene(motivating::scaled(scene, scale), "", "scaled.json", {});
}

void run(Scene& scene, int steps)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    const Solver solver = chapter08_solver(scene.contact, settings);
    Contacts contacts;
    for (int i = 0; i < steps; ++i)
        advance(scene.world, contacts, solver, scene.dt);
}

/// Runs a trial in four other scales.
void compare(const motivating::ScaleTrial& trial)
{
    CAPTURE(trial.name);
    Scene metres = scene_at(trial.scene, {});
    run(metres, trial.steps);
    for (const SceneScale& scale :
         {SceneScale{1.0 / 1024}, SceneScale{64, 1.0 / 8}, SceneScale{1e-3, 3}, SceneScale{100, 0.7}}) {
        CAPTURE(scale.length);
        Scene other = scene_at(trial.scene, scale);
        run(other, trial.steps);
        CHECK(motivating::difference(metres.world, other.world, scale) < 1e-8);
    }
}

}  // namespace

TEST_CASE("scales: what begins inside a plane or a body is let out alike in any size, with any density")
{
    for (const motivating::ScaleTrial& trial : motivating::inside_scale_trials())
        compare(trial);
}

TEST_CASE("scales: what falls, slides, rolls and bends moves alike in any size, with any density")
{
    for (const motivating::ScaleTrial& trial : motivating::scale_trials())
        compare(trial);
}
