#include "common/scenes/drawn_body.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace enduring {
namespace {

/// Of the body's size [1]: thinner rods vanish in a small picture, thicker ones hide how far bodies are
/// apart.
constexpr double rod_radius = 0.006, point_radius = 0.02;

/// A rod has a triangle at each end, a point the same with a twist: six vertices and eight faces.
constexpr int vertices_each = 6, faces_each = 8;
constexpr std::array<Face, faces_each> rod_faces{
    {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};

/// Edges, and points without one, by their vertices; a point has its own twice.
std::vector<Edge> drawn_items(const Body& body)
{
    const SurfaceTopology& surface = body.surface();
    std::vector<Edge> items(surface.edges().begin(), surface.edges().end());
    for (int v = 0; v < surface.vertex_count(); ++v)
        if (surface.edges_around_vertex(v).empty())
            items.push_back({v, v});
    return items;
}

bool is_frame(const Body& body) { return body.surface().faces().empty(); }

void append_rod(const Vec3& from, const Vec3& to, double size, std::vector<Vec3>& points)
{
    const bool is_point = from == to;
    const Vec3 along = is_point ? Vec3(Vec3::UnitY()) : Vec3((to - from).stableNormalized()),
               x = along.unitOrthogonal(), y = along.cross(x);
    const double radius = (is_point ? point_radius : rod_radius) * size;
    for (const double end : {-1.0, 1.0})
        for (int i = 0; i < 3; ++i) {
            constexpr double third = 2 * std::numbers::pi / 3;
            const double angle = third * (i + (is_point && end > 0 ? 0.5 : 0));
            const Vec3 out = radius * (std::cos(angle) * x + std::sin(angle) * y);
            points.push_back((end < 0 ? from : to) + out +
                             (is_point ? Vec3(end * radius / 2 * along) : Vec3(Vec3::Zero())));
        }
}

}  // namespace

std::vector<Vec3> drawn_points(const Body& body)
{
    const auto positions = body.positions_t0();
    if (!is_frame(body))
        return {positions.begin(), positions.end()};
    std::vector<Vec3> points;
    for (const auto& [a, b] : drawn_items(body))
        append_rod(positions[static_cast<std::size_t>(a)], positions[static_cast<std::size_t>(b)],
                   body.size(), points);
    return points;
}

std::vector<Face> drawn_faces(const Body& body)
{
    if (!is_frame(body))
        return {body.surface().faces().begin(), body.surface().faces().end()};
    std::vector<Face> faces;
    const auto items = static_cast<int>(drawn_items(body).size());
    for (int item = 0; item < items; ++item)
        for (const auto& [a, b, c] : rod_faces) {
            const int first = vertices_each * item;
            faces.push_back({first + a, first + b, first + c});
        }
    return faces;
}

std::vector<int> vertices_of_drawn_face(const Body& body, int face)
{
    if (!is_frame(body)) {
        const Face& corners = body.surface().faces()[static_cast<std::size_t>(face)];
        return {corners.begin(), corners.end()};
    }
    const auto [a, b] = drawn_items(body)[static_cast<std::size_t>(face / faces_each)];
    return a == b ? std::vector{a} : std::vector{a, b};
}

}  // namespace enduring
