#pragma once

#include "common/experiments/render/on/graphics.hpp"
#include "common/experiments/render/on/lights.hpp"

#include <array>

namespace enduring {

/// For each light, how deep its rays reach into the stage.
class ShadowMaps {
public:
    ShadowMaps();

    /// Draws the corners of the bound vertex array into every map.
    /// @param radius  of the ball around everything drawn
    void fill(const std::array<DirectionalLight, light_count>& lights, double radius, GLsizei corners);
    /// Tells a program with the `light` part of the shaders where the light comes from.
    void hand_over(GLuint program, const std::array<DirectionalLight, light_count>& lights,
                   double radius) const;

private:
    graphics::Handle maps_, framebuffer_, program_;
};

}  // namespace enduring
