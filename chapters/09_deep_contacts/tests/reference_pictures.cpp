#include "chapters/09_deep_contacts/experiments/draw_crossing.hpp"
#include "chapters/09_deep_contacts/experiments/folding_scenes.hpp"
#include "chapters/09_deep_contacts/experiments/inside_scenes.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/scene_view.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter09;

namespace {

/// A stage, seen from near, against renders/09_deep_contacts/NAME.png.
void check_picture(Stage stage, const Vec3& seen_from, const std::string& name)
{
    const ReferenceCheck check = check_reference_view(std::move(stage), seen_from,
                                                      "09_deep_contacts/" + name + ".png", 0.04);
    CHECK_MESSAGE(check.passed, check.message);
}

}  // namespace

TEST_CASE("bunny curve: where the bunny and the bowl cross is as in its reference picture" *
          doctest::skip(!pictures_are_on))
{
    const Scene scene = bunny_in_wall();
    Stage stage = stage_of(scene.world, scene);
    mark_crossing(stage, scene.world);
    check_picture(std::move(stage), {1.3, 0.9, 2.45}, "bunny_curve");
}

TEST_CASE("self-contact: the folds of a fallen strip lie on each other as in their reference picture" *
          doctest::skip(!pictures_are_on))
{
    SoftRun run = falling_strip({3e4, 2, 0.005, 0.3});
    fold(run, 150);
    check_picture(stage_of(run.scene.world, run.scene), {0.4, 0.4, 1}, "folded_strip");
}
