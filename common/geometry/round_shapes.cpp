#include "common/geometry/round_shapes.hpp"

#include "common/geometry/shape_arguments.hpp"

#include <algorithm>
#include <map>
#include <numbers>

namespace enduring {
namespace {

SurfaceMesh icosahedron()
{
    const double g = std::numbers::phi;
    SurfaceMesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    return mesh;
}

/// Cuts every triangle into four at the middles of its edges.
void refine(SurfaceMesh& mesh)
{
    std::map<Edge, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [entry, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                         static_cast<int>(mesh.vertices.size()));
        if (is_new) {
            const Vec3 x = 0.5 * (mesh.vertices[a] + mesh.vertices[b]);
            mesh.vertices.push_back(x);
        }
        return entry->second;
    };
    std::vector<Face> faces;
    for (const auto& [a, b, c] : mesh.faces) {
        const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        faces.insert(faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.faces = std::move(faces);
}

/// A point of the bowl's outline: distance from the axis, and height.
using Outline = std::vector<Eigen::Vector2d>;

/// From the bottom outside over the rim to the bottom inside; the first and the last point lie on the axis.
Outline bowl_outline(const BowlShape& shape)
{
    const double outer = shape.inner_radius + shape.thickness;
    const auto on_sphere = [](double radius, double angle) {
        return Eigen::Vector2d(radius * std::sin(angle), -radius * std::cos(angle));
    };
    Outline outline;
    const double foot_angle = std::asin(shape.foot_radius / outer);
    outline.emplace_back(0, on_sphere(outer, foot_angle).y());
    for (int i = shape.foot_radius > 0 ? 0 : 1; i <= shape.segments_along; ++i)
        outline.push_back(
            on_sphere(outer, foot_angle + (shape.rim_angle - foot_angle) * i / shape.segments_along));

    const Eigen::Vector2d middle = on_sphere(shape.inner_radius + shape.thickness / 2, shape.rim_angle);
    const Eigen::Vector2d across = on_sphere(1, shape.rim_angle), along(-across.y(), across.x());
    for (int i = 1; i < shape.segments_rim; ++i) {
        const double turn = std::numbers::pi * i / shape.segments_rim;
        outline.push_back(middle + shape.thickness / 2 * (std::cos(turn) * across + std::sin(turn) * along));
    }
    for (int i = shape.segments_along; i > 0; --i)
        outline.push_back(on_sphere(shape.inner_radius, shape.rim_angle * i / shape.segments_along));
    outline.emplace_back(0, -shape.inner_radius);
    return outline;
}

/// Turns an outline about y. It starts and ends on the axis; what it
/// turns around keeps the solid on its left.
SurfaceMesh revolve(const Outline& outline, int around)
{
    SurfaceMesh mesh;
    const int rings = static_cast<int>(outline.size()) - 2;
    mesh.vertices.emplace_back(0, outline.front().y(), 0);
    for (int ring = 1; ring <= rings; ++ring)
        for (int j = 0; j < around; ++j) {
            const double angle = 2 * std::numbers::pi * j / around;
            const Eigen::Vector2d& at = outline[ring];
            mesh.vertices.emplace_back(at.x() * std::cos(angle), at.y(), at.x() * std::sin(angle));
        }
    mesh.vertices.emplace_back(0, outline.back().y(), 0);

    const int last = static_cast<int>(mesh.vertices.size()) - 1;
    const auto vertex = [&](int ring, int j) { return 1 + ring * around + j % around; };
    for (int j = 0; j < around; ++j) {
        mesh.faces.push_back({0, vertex(0, j), vertex(0, j + 1)});
        for (int ring = 0; ring + 1 < rings; ++ring) {
            const int a = vertex(ring, j), b = vertex(ring + 1, j), c = vertex(ring + 1, j + 1),
                      d = vertex(ring, j + 1);
            mesh.faces.insert(mesh.faces.end(), {{a, b, c}, {a, c, d}});
        }
        mesh.faces.push_back({vertex(rings - 1, j), last, vertex(rings - 1, j + 1)});
    }
    return mesh;
}

void require_bowl(const BowlShape& shape)
{
    require_length("inner_radius of a bowl", shape.inner_radius);
    require_length("thickness of a bowl", shape.thickness);
    require_count("segments_around of a bowl", shape.segments_around, 3, 2000);
    require_count("segments_along of a bowl", shape.segments_along, 2, 1000);
    require_count("segments_rim of a bowl", shape.segments_rim, 2, 1000);

    const double inner = shape.inner_radius, outer = inner + shape.thickness;
    if (!(shape.rim_angle > 0 && shape.rim_angle < std::numbers::pi) ||
        (inner + outer) / 2 * std::sin(shape.rim_angle) <= shape.thickness / 2)
        throw InputError("rim_angle of a bowl is " + std::to_string(shape.rim_angle) +
                         "; it must lie in (0, pi) and keep the rim clear of the axis");
    const double widest_foot = std::min(std::sqrt(outer * outer - inner * inner),
                                        outer * std::sin(std::min(shape.rim_angle, std::numbers::pi / 2)));
    if (!(shape.foot_radius >= 0 && shape.foot_radius < widest_foot))
        throw InputError("foot_radius of a bowl is " + std::to_string(shape.foot_radius) +
                         "; it must lie in [0, " + std::to_string(widest_foot) +
                         ") for these radii and this rim");
}

}  // namespace

SurfaceMesh sphere(double radius, int subdivisions)
{
    require_length("radius of a sphere", radius);
    require_count("subdivisions of a sphere", subdivisions, 0, 8);
    SurfaceMesh mesh = icosahedron();
    for (int i = 0; i < subdivisions; ++i) {
        refine(mesh);
        for (Vec3& x : mesh.vertices)  // at every level: pushing out only at the end would bunch the vertices
            x.normalize();
    }
    for (Vec3& x : mesh.vertices)
        x = radius * x.normalized();
    return mesh;
}

SurfaceMesh torus(double radius, double tube_radius, int around, int across)
{
    require_length("radius of a torus", radius);
    require_length("tube_radius of a torus", tube_radius);
    if (tube_radius >= radius)
        throw InputError("tube_radius of a torus is " + std::to_string(tube_radius) +
                         "; it must be below the radius of " + std::to_string(radius));
    require_count("around of a torus", around, 3, 2000);
    require_count("across of a torus", across, 3, 2000);
    SurfaceMesh mesh;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across,
                         from_axis = radius + tube_radius * std::cos(b);
            mesh.vertices.emplace_back(from_axis * std::cos(a), -tube_radius * std::sin(b),
                                       from_axis * std::sin(a));
            const int next_i = (i + 1) % around, next_j = (j + 1) % across, here = across * i + j,
                      ahead = across * next_i + j, up = across * i + next_j, both = across * next_i + next_j;
            mesh.faces.insert(mesh.faces.end(), {{here, ahead, both}, {here, both, up}});
        }
    return mesh;
}

SurfaceMesh bowl(const BowlShape& shape)
{
    require_bowl(shape);
    return revolve(bowl_outline(shape), shape.segments_around);
}

}  // namespace enduring
