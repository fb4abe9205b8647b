#pragma once

#include "common/render/picture.hpp"
#include "common/render/stage.hpp"

#include <string>

namespace enduring {

/// Writes UTF-8 text in DejaVu Sans; `x`, `y` are the left end of its base line [px].
/// @param halo  a pale rim that keeps the text readable on anything
void draw_text(Picture& picture, const std::string& text, double x, double y, double size_px, const Vec3& color, bool halo = false);

/// Width of a line [px].
double text_width(const std::string& text, double size_px);

/// A label where its stage has it; behind the camera it is not drawn.
void draw_label(Picture& picture, const Label& label, const Camera& camera);

}  // namespace enduring
