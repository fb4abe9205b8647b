#include "common/experiments/render/on/lights.hpp"

#include <cmath>
#include <numbers>

namespace enduring {
namespace {

constexpr double pi = std::numbers::pi, golden_angle = 2.399963229728653;
const Vec3 sun_color(1.00, 0.955, 0.89), sky_color(0.90, 0.955, 1.03);

DirectionalLight light_from(const Vec3& toward, const Vec3& radiance)
{
    DirectionalLight light;
    light.rows.row(2) = toward.normalized();
    light.rows.row(0) = toward.unitOrthogonal();
    light.rows.row(1) = light.rows.row(2).cross(light.rows.row(0));
    light.radiance = radiance;
    return light;
}

}  // namespace

std::array<DirectionalLight, light_count> studio_lights(const Camera& camera, const Vec3& up)
{
    // The azimuth follows the camera, so that a picture from behind is lit as well as one from the front.
    const Vec3 level = (camera.forward() - camera.forward().dot(up) * up).normalized();
    const Vec3 front = level.norm() > 0.5 ? level : up.unitOrthogonal(), right = front.cross(up);
    const double azimuth = 0.72, elevation = 0.92, sun_radius = 0.14;
    const Vec3 sun = std::sin(elevation) * up -
                     std::cos(elevation) * (std::cos(azimuth) * front + std::sin(azimuth) * right);
    const Vec3 x = sun.unitOrthogonal(), y = sun.cross(x);

    std::array<DirectionalLight, light_count> lights;
    for (int i = 0; i < sun_count; ++i) {  // a spiral over the sun's disc
        const double r = sun_radius * std::sqrt((i + 0.5) / sun_count), angle = i * golden_angle;
        lights[i] = light_from(sun + r * (std::cos(angle) * x + std::sin(angle) * y),
                               0.72 / sun_count * sun_color);
    }
    const int sky_count = light_count - sun_count;
    // a spiral from the zenith to 8 degrees above the horizon, equal areas
    for (int i = 0; i < sky_count; ++i) {
        const double height = 1 - (1 - std::sin(8 * pi / 180)) * (i + 0.5) / sky_count,
                     angle = i * golden_angle;
        const Vec3 around = std::cos(angle) * front + std::sin(angle) * right;
        lights[sun_count + i] = light_from(height * up + std::sqrt(1 - height * height) * around,
                                           0.86 / sky_count * sky_color);
    }
    return lights;
}

}  // namespace enduring
