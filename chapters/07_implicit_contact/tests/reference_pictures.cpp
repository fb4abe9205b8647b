#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/scene_view.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

/// Some time of a scene, seen from near, against renders/07_implicit_contact/NAME.png.
void check_after(Scene scene, double time, const Vec3& seen_from, const std::string& name)
{
    watch(scene, time);
    const ReferenceCheck check = check_reference_view(stage_of(scene.world, scene), seen_from,
                                                      "07_implicit_contact/" + name + ".png");
    CHECK_MESSAGE(check.passed, check.message);
}

}  // namespace

TEST_CASE("heap: eight cubes that have just landed are as in their reference picture" *
          doctest::skip(!pictures_are_on))
{
    check_after(scene_of(loose_cubes(8, 2, 1), 1.0 / 60), 1.2, {0.6, 0.5, 1}, "heap");
}

TEST_CASE("card house: after half a second it stands as in its reference picture" *
          doctest::skip(!pictures_are_on))
{
    check_after(scene_of(card_house(3, 15), 1.0 / 60), 0.5, {1, 0.6, 2}, "card_house");
}

TEST_CASE("arch: after half a second it stands as in its reference picture" * doctest::skip(!pictures_are_on))
{
    check_after(arch(20, 5, 1.0 / 60), 0.5, {0.8, 0.4, 2}, "arch");
}
