#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/01_particle_plane/solver.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/run/run.hpp"

#include <doctest/doctest.h>

using namespace enduring;

TEST_CASE("ground scene: bar and cube as in their reference picture" * doctest::skip(!pictures_are_on))
{
    Scene scene = load_scene(scene_file("ground"), R"({"duration": 0.24})");
    const RunResult result = run(scene, chapter01_solver(scene.contact));
    Stage stage = stage_of(scene.world, scene);
    mark_contacts(stage, scene.world, result.contacts);
    const ReferenceCheck check = check_reference_picture(Renderer(480, 320).draw(stage),
                                                         "01_particle_plane/ground.png");
    CHECK_MESSAGE(check.passed, check.message);
}
