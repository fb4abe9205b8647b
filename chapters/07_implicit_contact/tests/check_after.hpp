#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/scene_view.hpp"

#include <doctest/doctest.h>

namespace enduring::chapter07 {

/// Some time of a scene under a solver, seen from near, against a picture below renders/.
inline void check_after(Scene scene, double time, MakeSolver make, const Vec3& seen_from,
                        const std::string& picture)
{
    watch(scene, time, make);
    const ReferenceCheck check = check_reference_view(stage_of(scene.world, scene), seen_from, picture);
    CHECK_MESSAGE(check.passed, check.message);
}

}  // namespace enduring::chapter07
