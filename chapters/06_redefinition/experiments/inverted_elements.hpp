#pragma once

#include "common/experiments/render/stage.hpp"
#include "common/scenes/scene.hpp"

namespace enduring::chapter06 {

int count_inverted(const World& world);

/// The world with translucent bodies and every element that is turned
/// inside out in solid red (thesis figure 7.14).
Stage stage_of_inverted(const Scene& scene);

}  // namespace enduring::chapter06
