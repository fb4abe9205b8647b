#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/scene_view.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

/// Some time of a scene, seen from near, against renders/07_implicit_contact/NAME.png.
void check_after(Scene scene, double time, const Vec3& seen_from, const std::string& name)
{
    watch(scene, time, chapter07_solver);
    const ReferenceCheck check = check_reference_view(stage_of(scene.world, scene), seen_from,
                                                      "07_implicit_contact/" + name + ".png");
    CHECK_MESSAGE(check.passed, check.message);
}

}  // namespace

TEST_CASE("stack: ten cubes, each turned against the one below, stand as in their reference picture" *
          doctest::skip(!pictures_are_on))
{
    check_after(scene_of(stack_of(10), 0.01), 0.5, {1, 0.4, 2}, "stack");
}
