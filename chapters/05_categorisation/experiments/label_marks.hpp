#pragma once

#include "common/experiments/render/scene_view.hpp"

namespace enduring::chapter05 {

/// Triangles drawn; hooked pairs in orange, all others in the thesis' colours.
void mark_by_label(Stage& stage, const World& world, const Contacts& contacts);

}  // namespace enduring::chapter05
