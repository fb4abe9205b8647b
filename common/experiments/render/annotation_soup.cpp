#include "common/experiments/render/annotation_soup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring {
namespace {

constexpr int sides = 14;

struct Frame {
    Vec3 origin, x, y, axis;

    Frame(const Vec3& from, const Vec3& along) : origin(from), axis(along)
    {
        x = along.unitOrthogonal();
        y = along.cross(x);
    }
    Vec3 around(int i) const
    {
        return std::cos(2 * std::numbers::pi * i / sides) * x +
               std::sin(2 * std::numbers::pi * i / sides) * y;
    }
};

/// A point on a surface of revolution: how far along the axis, how far
/// from it, and the normal's slope along the axis.
struct Ring {
    double along, radius, normal_along, normal_out;
};

void revolve(TriangleSoup& soup, const Frame& frame, const std::vector<Ring>& profile, const Vec3& color,
             const Vec3& centre)
{
    const auto corner = [&](const Ring& ring, int i) {
        const Vec3 position = frame.origin + ring.along * frame.axis + ring.radius * frame.around(i) - centre;
        const Vec3 normal = ring.normal_along * frame.axis + ring.normal_out * frame.around(i);
        return Corner{position.cast<float>(), normal.normalized().cast<float>(), color.cast<float>(),
                      Eigen::Vector3f::Ones()};
    };
    for (std::size_t r = 0; r + 1 < profile.size(); ++r)
        for (int i = 0; i < sides; ++i) {
            const Corner a = corner(profile[r], i), b = corner(profile[r], i + 1);
            const Corner c = corner(profile[r + 1], i + 1), d = corner(profile[r + 1], i);
            soup.insert(soup.end(), {a, b, c, a, c, d});
        }
}

void add_rod(TriangleSoup& soup, const Vec3& from, const Vec3& to, double radius, const Vec3& color,
             const Vec3& centre)
{
    const double length = (to - from).norm();
    if (length > 0)
        revolve(soup, Frame(from, (to - from) / length),
                {{0, 0, -1, 0},
                 {0, radius, -1, 0},
                 {0, radius, 0, 1},
                 {length, radius, 0, 1},
                 {length, radius, 1, 0},
                 {length, 0, 1, 0}},
                color, centre);
}

void add_head(TriangleSoup& soup, const Vec3& base, const Vec3& tip, double radius, const Vec3& color,
              const Vec3& centre)
{
    const double length = (tip - base).norm();
    revolve(soup, Frame(base, (tip - base) / length),
            {{0, 0, -1, 0}, {0, radius, -1, 0}, {0, radius, radius, length}, {length, 0, radius, length}},
            color, centre);
}

}  // namespace

void add_dot(TriangleSoup& soup, const Dot& dot, const Camera& camera, int height, const Vec3& centre)
{
    const double radius = dot.radius_px * camera.pixel_size(dot.point, height);
    std::vector<Ring> profile;
    for (int i = 0; i <= sides / 2; ++i) {
        const double angle = std::numbers::pi * i / (sides / 2) - std::numbers::pi / 2;
        profile.push_back(
            {radius * std::sin(angle), radius * std::cos(angle), std::sin(angle), std::cos(angle)});
    }
    revolve(soup, Frame(dot.point, Vec3::UnitY()), profile, dot.color, centre);
}

void add_segment(TriangleSoup& soup, const Segment& segment, const Camera& camera, int height,
                 const Vec3& centre)
{
    const double length = (segment.to - segment.from).norm();
    if (length == 0)
        return;
    const double pixel = camera.pixel_size(segment.to, height), radius = 0.5 * segment.width_px * pixel;
    const Vec3 along = (segment.to - segment.from) / length;
    const double head = segment.arrow ? std::min(9 * radius, 0.6 * length) : 0;
    const Vec3 end = segment.to - head * along;

    if (segment.dashed) {
        const double dash = 8 * radius;
        for (double from = 0; from < length - head; from += 1.8 * dash)
            add_rod(soup, segment.from + from * along,
                    segment.from + std::min(from + dash, length - head) * along, radius, segment.color,
                    centre);
    } else {
        add_rod(soup, segment.from, end, radius, segment.color, centre);
    }
    if (segment.arrow)
        add_head(soup, end, segment.to, head / 3, segment.color, centre);
}

void add_triangle(TriangleSoup& soup, const TintedTriangle& triangle, const Vec3& centre)
{
    const auto& [a, b, c] = triangle.corners;
    const Eigen::Vector3f normal = (b - a).cross(c - a).normalized().cast<float>();
    for (const Vec3& corner : triangle.corners)
        soup.push_back(
            {(corner - centre).cast<float>(), normal, triangle.color.cast<float>(), Eigen::Vector3f::Ones()});
}

}  // namespace enduring
