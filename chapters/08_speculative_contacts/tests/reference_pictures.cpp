#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/08_speculative_contacts/solver.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/scene_view.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

/// Some time of a scene, seen from near, against renders/08_speculative_contacts/NAME.png.
void check_after(Scene scene, double time, const Vec3& seen_from, const std::string& name)
{
    chapter07::watch(scene, time, chapter08_solver);
    const ReferenceCheck check = check_reference_view(stage_of(scene.world, scene), seen_from,
                                                      "08_speculative_contacts/" + name + ".png");
    CHECK_MESSAGE(check.passed, check.message);
}

}  // namespace

TEST_CASE("card house: after half a second it stands as in its reference picture" *
          doctest::skip(!pictures_are_on))
{
    check_after(chapter07::scene_of(chapter07::card_house(3, 15), 1.0 / 60), 0.5, {1, 0.6, 2}, "card_house");
}

TEST_CASE("arch: after half a second it stands as in its reference picture" * doctest::skip(!pictures_are_on))
{
    check_after(chapter07::arch(20, 5, 1.0 / 60), 0.5, {0.8, 0.4, 2}, "arch");
}
