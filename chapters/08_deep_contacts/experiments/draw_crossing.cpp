#include "chapters/08_deep_contacts/experiments/draw_crossing.hpp"

namespace enduring::chapter08 {

void draw_curves(Stage& stage, const Intersection& intersection, const StillSurface& a, const StillSurface& b)
{
    for (const IntersectionCurve& curve : intersection.curves) {
        const std::size_t count = curve.piercings.size();
        const auto point = [&](std::size_t i) {
            return point_of(intersection.piercings[curve.piercings[i % count]], a, b);
        };
        for (std::size_t i = 0; i < count; ++i)
            stage.segments.push_back({point(i), point(i + 1), palette::colliding_vertex, 3.5});
    }
}

long mark_inside(Stage& stage, const SurfaceRegions& regions, const StillSurface& surface, const Vec3& color)
{
    long inside = 0;
    for (int vertex = 0; vertex < surface.topology.vertex_count(); ++vertex)
        if (regions.winding_of_vertex(vertex) > 0) {
            stage.dots.push_back({surface.positions[vertex], color, 3.5});
            ++inside;
        }
    return inside;
}

}  // namespace enduring::chapter08
