#include "chapters/07_implicit_contact/solver.hpp"
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
    const Solver solver = chapter07_solver(scene.contact, settings);
    Contacts contacts;
    for (int i = 0; i < steps; ++i)
        advance(scene.world, contacts, solver, scene.dt);
}

}  // namespace

TEST_CASE("scales: a scene moves alike in millimetres, metres and hundreds of metres, and with any density")
{
    for (const motivating::ScaleTrial& trial : motivating::scale_trials()) {
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
}
