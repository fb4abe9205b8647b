#include "chapters/09_deep_contacts/experiments/overlap_shape.hpp"
#include "chapters/09_deep_contacts/overlaps.hpp"
#include "common/geometry/box_shapes.hpp"
#include "live/figures.hpp"

#include <Eigen/Geometry>

#include <numbers>

namespace enduring::live {
namespace {

/// What is moved: a cube, or a bar.
SurfaceMesh moved_body(bool bar, const Vec3& place, double turn_deg, double tilt_deg)
{
    SurfaceMesh mesh = bar ? box({2.4, 0.5, 0.5}, {6, 2, 2}) : box({1, 1, 1}, {3, 3, 3});
    const auto about = [](double degrees, const Vec3& axis) {
        return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis);
    };
    const Eigen::Quaterniond turn = about(turn_deg, Vec3::UnitY()) * about(tilt_deg, Vec3::UnitZ());
    for (Vec3& x : mesh.vertices)
        x = turn * x + place;
    return mesh;
}

/// Edges whose faces lie in one plane are left out.
void append_edges(const OverlapShape& shape, Numbers& list)
{
    const auto normal = [&](int face) {
        const auto [a, b, c] = shape.topology().faces()[face];
        const auto& x = shape.positions();
        return Vec3((x[b] - x[a]).cross(x[c] - x[a]).normalized());
    };
    int edge = 0;
    for (const auto& [from, to] : shape.topology().edges()) {
        const auto [one, other] = shape.topology().faces_at_edge(edge++);
        if (normal(one).dot(normal(other)) < 0.99)
            for (const int vertex : {from, to}) {
                const Vec3& x = shape.positions()[vertex];
                list.insert(list.end(), {x.x(), x.y(), x.z()});
            }
    }
}

void append(Numbers& numbers, const Numbers& part, double count)
{
    numbers.push_back(count);
    numbers.insert(numbers.end(), part.begin(), part.end());
}

void append_inside(const OverlapShape& shape, const SurfaceRegions& regions, Numbers& numbers)
{
    Numbers inside;
    for (int vertex = 0; vertex < shape.topology().vertex_count(); ++vertex)
        if (regions.winding_of_vertex(vertex) > 0) {
            const Vec3& x = shape.positions()[vertex];
            inside.insert(inside.end(), {x.x(), x.y(), x.z()});
        }
    append(numbers, inside, static_cast<double>(inside.size()) / 3);
}

}  // namespace

Numbers crossing(bool bar, double x, double y, double z, double turn_deg, double tilt_deg)
{
    const OverlapShape a(moved_body(bar, {x, y, z}, turn_deg, tilt_deg)),
        b(bar ? box({0.5, 1.6, 1.6}, {2, 5, 5}) : box({2, 0.8, 2}, {5, 2, 5}));
    const Intersection crossed = trace_intersection(a.still(), b.still());
    Numbers result;
    for (const OverlapShape& shape : {a, b}) {
        Numbers edges;
        append_edges(shape, edges);
        append(result, edges, static_cast<double>(edges.size()) / 6);
    }
    append_inside(a, flood_regions(crossed.piercings, a.still(), b.still(), true), result);
    append_inside(b, flood_regions(crossed.piercings, a.still(), b.still(), false), result);
    Numbers ways;
    for (const Overlap& overlap : find_overlaps(a.still(), b.still()))
        ways.insert(ways.end(), {overlap.separation_direction.x(), overlap.separation_direction.y(),
                                 overlap.separation_direction.z()});
    append(result, ways, static_cast<double>(ways.size()) / 3);
    result.push_back(static_cast<double>(crossed.curves.size()));
    for (const IntersectionCurve& curve : crossed.curves) {
        Numbers points;
        for (const int piercing : curve.piercings) {
            const Vec3 point = point_of(crossed.piercings[piercing], a.still(), b.still());
            points.insert(points.end(), {point.x(), point.y(), point.z()});
        }
        append(result, points, static_cast<double>(points.size()) / 3);
    }
    return result;
}

}  // namespace enduring::live
