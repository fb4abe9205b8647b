#pragma once

#include "common/experiments/render/on/graphics.hpp"
#include "common/experiments/render/picture.hpp"

namespace enduring {

/// What the stage is painted on: twice the picture's size in both directions, in linear light.
class Canvas {
public:
    Canvas(int width, int height);

    /// Clears the canvas to the backdrop and makes it the place that is painted on.
    void begin();
    /// Averages, brightens and rounds the painting to a picture.
    Picture develop();

    int rows() const { return 2 * height_; }

private:
    int width_, height_;
    graphics::Handle samples_, depth_, painting_, bytes_, developed_, backdrop_program_, develop_program_,
        no_corners_;
};

}  // namespace enduring
