#pragma once

#include "common/experiments/render/camera.hpp"

#include <array>

namespace enduring {

inline constexpr int light_count = 28, sun_count = 8;

/// One of the directions that light comes from.
struct DirectionalLight {
    Mat3 rows;      ///< across, upward, toward the light: turns the stage so that the light looks along -z
    Vec3 radiance;  ///< what a surface facing it receives
};

/// A soft sun from the upper left of the camera (the first sun_count
/// lights) and a sky of even brightness above `up`.
std::array<DirectionalLight, light_count> studio_lights(const Camera& camera, const Vec3& up);

}  // namespace enduring
