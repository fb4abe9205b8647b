#pragma once

#include "common/experiments/render/picture.hpp"
#include "common/experiments/render/stage.hpp"

namespace enduring {

/// A label on a pale plate that keeps it readable on anything, where its
/// stage has it; behind the camera it is not drawn.
void draw_label(Picture& picture, const Label& label, const Camera& camera);

}  // namespace enduring
