#include "chapters/05_categorisation/experiments/direction_sphere.hpp"

#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/strip.hpp"
#include "common/geometry/round_shapes.hpp"

namespace enduring::chapter05 {
namespace {

const Vec3 towards_eye(0.55, 0.75, 1);
constexpr int width = 380, height = 340;

const std::array<Vec3, 4> group_colors{palette::blue, srgb(0xc0392b), srgb(0xa9c4dc), srgb(0xe8a25a)};

/// The area of the part of the sphere that a small face stands for, but for its curvature.
double area(const std::vector<Vec3>& points, const Face& face)
{
    const Vec3& a = points[face[0]];
    return 0.5 * (points[face[1]] - a).cross(points[face[2]] - a).norm();
}

Vec3 middle(const std::vector<Vec3>& points, const Face& face)
{
    Vec3 sum = Vec3::Zero();
    for (const int vertex : face)
        sum += points[vertex];
    return sum.normalized();
}

std::vector<Segment> span_arrows(const Corner& corner, double from, double to)
{
    const std::vector<Vec3> normals = normal_span(corner.surface(), corner.faces());
    std::vector<Segment> arrows;
    for (const Vec3& normal : normals)
        arrows.push_back({.from = from * normal,
                          .to = to * normal,
                          .color = palette::ink,
                          .width_px = 2.5,
                          .arrow = true});
    arrows.back().color = palette::colliding_edge;  // the average
    return arrows;
}

Camera camera_at(const Vec3& target, double distance)
{
    Camera camera;
    camera.target = target;
    camera.eye = target + distance * towards_eye.normalized();
    camera.field_of_view_deg = 30;
    return camera;
}

Stage corner_stage(const Corner& corner)
{
    Stage stage;
    stage.bodies.push_back({.positions = corner.positions,
                            .faces = {corner.topology.faces().begin(), corner.topology.faces().end()},
                            .color = palette::sand,
                            .wireframe = true});
    stage.segments = span_arrows(corner, 0, 0.8);
    stage.dots.push_back({.point = Vec3::Zero()});
    stage.camera = camera_at({0, -0.05, 0}, 4.1);
    return stage;
}

Stage sphere_stage(const DirectionSphere& sphere, const Corner& corner)
{
    Stage stage;
    for (std::size_t group = 0; group < sphere.groups.size(); ++group)
        if (!sphere.groups[group].empty())
            stage.bodies.push_back({.positions = sphere.points,
                                    .faces = sphere.groups[group],
                                    .color = group_colors[group],
                                    .smooth = true,
                                    .casts_shadow = false});
    stage.segments = span_arrows(corner, 1, 1.25);
    stage.camera = camera_at({0, 0.1, 0}, 5.2);
    return stage;
}

}  // namespace

DirectionSphere directions_around(const Corner& corner, int subdivisions)
{
    const SurfaceMesh ball = sphere(1, subdivisions);
    DirectionSphere result;
    result.points = ball.vertices;
    double total = 0, possible = 0, average_finds = 0, span_finds = 0, span_allows = 0;
    for (const Face& face : ball.faces) {
        const Vec3 normal = -middle(ball.vertices, face);
        const double share = area(ball.vertices, face);
        const bool touches = can_touch(corner, normal), regular = span_says_regular(corner, normal);
        total += share;
        possible += touches ? share : 0;
        average_finds += touches && average_says_regular(corner, normal) ? share : 0;
        span_finds += touches && regular ? share : 0;
        span_allows += !touches && regular ? share : 0;
        result.groups[(touches ? 0 : 2) + (regular ? 0 : 1)].push_back(face);
    }
    const double some = possible > 0 ? possible : 1;
    result.shares = {possible / total, average_finds / some, span_finds / some,
                     span_allows / (total - possible)};
    return result;
}

Picture draw(const std::vector<DirectionSphere>& spheres, const std::vector<Corner>& corners)
{
    Renderer renderer(width, height);
    std::vector<StripPicture> pictures;
    for (const Corner& corner : corners)
        pictures.push_back({renderer.draw(corner_stage(corner)), corner.name});
    for (std::size_t i = 0; i < spheres.size(); ++i)
        pictures.push_back({renderer.draw(sphere_stage(spheres[i], corners[i])), "directions"});
    return strip(pictures, static_cast<int>(corners.size()));
}

}  // namespace enduring::chapter05
