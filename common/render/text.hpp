#pragma once

#include "common/render/picture.hpp"
#include "common/render/stage.hpp"

#include <string>

namespace enduring {

/// Writes UTF-8 text in DejaVu Sans; `x`, `y` are the left end of its base line [px].
void draw_text(Picture& picture, const std::string& text, double x, double y, double size_px, const Vec3& color);

/// Width of a line [px].
double text_width(const std::string& text, double size_px);

/// A label on a pale plate that keeps it readable on anything, where its stage has it; behind the camera it is not drawn.
void draw_label(Picture& picture, const Label& label, const Camera& camera);

}  // namespace enduring
