#pragma once

#include "common/geometry/vector.hpp"

#include <vector>

namespace enduring {

/// A pinhole camera; lengths in the stage's unit.
struct Camera {
    Vec3 eye{3, 2, 4}, target{0, 0, 0};
    Vec3 up = Vec3::UnitY();
    double field_of_view_deg = 35;  ///< vertical

    Vec3 forward() const { return (target - eye).normalized(); }
    Vec3 right() const { return forward().cross(up).normalized(); }
    Vec3 true_up() const { return right().cross(forward()); }
    /// Distance of a point in front of the eye, along the view direction.
    double depth(const Vec3& point) const { return (point - eye).dot(forward()); }
    /// Where a point appears: x and y in pixels from the top left corner.
    Eigen::Vector2d project(const Vec3& point, int width, int height) const;
    /// Length that one pixel covers at that point.
    double pixel_size(const Vec3& point, int height) const;
};

/// A camera that sees all points, looking along a direction, as near as `margin` allows.
/// @param towards  from the points to the eye, any length
/// @param aspect   width / height of the picture
/// @param margin   free share of the picture on each side, 0 to 0.4
Camera frame(const std::vector<Vec3>& points, const Vec3& towards, double aspect = 16.0 / 9,
             double margin = 0.08, double field_of_view_deg = 30);

}  // namespace enduring
