#include "chapters/10_self_contact/experiments/folding_scenes.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/scene_view.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter10;

TEST_CASE("self-contact: the folds of a fallen strip lie on each other as in their reference picture" *
          doctest::skip(!pictures_are_on))
{
    SoftRun run = falling_strip({3e4, 2, 0.005, 0.3});
    fold(run, 150);
    const ReferenceCheck check = check_reference_view(stage_of(run.scene.world, run.scene), {0.4, 0.4, 1},
                                                      "10_self_contact/folded_strip.png", 0.04);
    CHECK_MESSAGE(check.passed, check.message);
}
