#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/scene_view.hpp"

#include <doctest/doctest.h>

using namespace enduring;

TEST_CASE("heap: a dropped cube comes to rest on its side, and brings no energy")
{
    for (const double dt : {0.01, 1.0 / 60}) {
        CAPTURE(dt);
        Scene scene = chapter07::scene_of({{.mass = 10, .centre = Vec3(0, 0.8, 0)}}, dt);
        const chapter07::PileOutcome outcome = chapter07::watch(scene, 2, chapter08_solver);
        CHECK(scene.world.bodies.front()->centre().y() == doctest::Approx(0.5).epsilon(1e-3));
        CHECK(outcome.drift_um_per_s < 1);
        CHECK(outcome.energy_gain_j < 1e-9 * 10 * 9.81 * 0.8);
        CHECK(outcome.pairs >= 3);  // fewer carry no side
        CHECK(outcome.solves.unconverged == 0);
    }
}

TEST_CASE("heap: cubes that have come down, with their pairs, are as in their reference picture" *
          doctest::skip(!pictures_are_on))
{
    constexpr int width = 480, height = 320;
    Scene scene = chapter07::scene_of(chapter07::loose_cubes(8, 2, 1), 1.0 / 60);
    Stage stage;
    WatchProbe last([&](const World& world, const Contacts& contacts, double) {
        stage = stage_of(world, scene);
        mark_pairs(stage, world, contacts);
    });
    chapter07::watch(scene, 2, chapter08_solver, &last);
    stage.camera = frame(points_of(stage), {0.6, 0.5, 1}, static_cast<double>(width) / height);
    const ReferenceCheck check = check_reference_picture(Renderer(width, height).draw(stage),
                                                         "08_contact_by_distance/heap.png");
    CHECK_MESSAGE(check.passed, check.message);
}
