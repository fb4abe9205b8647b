#include "chapters/09_deep_contacts/experiments/draw_crossing.hpp"
#include "chapters/09_deep_contacts/experiments/inside_scenes.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/scene_view.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter09;

TEST_CASE("bunny curve: where the bunny and the bowl cross is as in its reference picture" *
          doctest::skip(!pictures_are_on))
{
    const Scene scene = bunny_in_wall();
    Stage stage = stage_of(scene.world, scene);
    mark_crossing(stage, scene.world);
    const ReferenceCheck check = check_reference_view(std::move(stage), {1.3, 0.9, 2.45},
                                                      "09_deep_contacts/bunny_curve.png", 0.04);
    CHECK_MESSAGE(check.passed, check.message);
}
