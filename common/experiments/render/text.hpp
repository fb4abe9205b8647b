#pragma once

#include "common/experiments/render/picture.hpp"

#include <string>

namespace enduring {

/// Writes UTF-8 text in DejaVu Sans; `x`, `y` are the left end of its base line [px].
void draw_text(Picture& picture, const std::string& text, double x, double y, double size_px,
               const Vec3& color);

/// Width of a line [px].
double text_width(const std::string& text, double size_px);

}  // namespace enduring
