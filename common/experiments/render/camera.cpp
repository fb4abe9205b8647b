#include "common/experiments/render/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring {
namespace {

double half_height_at_unit_depth(const Camera& camera)
{
    return std::tan(camera.field_of_view_deg * std::numbers::pi / 360);
}

}  // namespace

Eigen::Vector2d Camera::project(const Vec3& point, int width, int height) const
{
    const double pixels = 0.5 * height / (half_height_at_unit_depth(*this) * depth(point));
    return {0.5 * width + pixels * (point - eye).dot(right()),
            0.5 * height - pixels * (point - eye).dot(true_up())};
}

double Camera::pixel_size(const Vec3& point, int height) const
{
    return 2 * half_height_at_unit_depth(*this) * depth(point) / height;
}

Camera frame(const std::vector<Vec3>& points, const Vec3& towards, double aspect, double margin,
             double field_of_view_deg)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& point : points)
        box.extend(point);
    Camera camera;
    camera.field_of_view_deg = field_of_view_deg;
    camera.target = points.empty() ? Vec3::Zero() : Vec3(box.center());
    camera.eye = camera.target + towards;
    const double tall = half_height_at_unit_depth(camera) * (1 - 2 * margin), wide = tall * aspect;
    const Vec3 forward = camera.forward(), right = camera.right(), up = camera.true_up();

    // The pyramid of view touches the points from four sides: each
    // point asks for planes no nearer than itself.
    double left_plane = -1e300, right_plane = -1e300, top_plane = -1e300, bottom_plane = -1e300;
    for (const Vec3& point : points) {
        const Vec3 p = point - camera.target;
        const double x = p.dot(right), y = p.dot(up), z = p.dot(forward);
        right_plane = std::max(right_plane, x - wide * z);
        left_plane = std::max(left_plane, -x - wide * z);
        top_plane = std::max(top_plane, y - tall * z);
        bottom_plane = std::max(bottom_plane, -y - tall * z);
    }
    if (points.empty())
        return camera;
    const double distance = std::max({(left_plane + right_plane) / (2 * wide),
                                      (bottom_plane + top_plane) / (2 * tall),
                                      1e-9 + 1e-3 * box.diagonal().norm()});
    const Vec3 shift = 0.5 * (right_plane - left_plane) * right + 0.5 * (top_plane - bottom_plane) * up;
    camera.target += shift;
    camera.eye = camera.target - distance * forward;
    return camera;
}

}  // namespace enduring
