#include "chapters/09_deep_contacts/experiments/draw_crossing.hpp"

namespace enduring::chapter09 {
namespace {

FaceTree fitted_tree(const Body& body)
{
    FaceTree tree(body.surface(), body.positions_t0());
    tree.refit({body.surface(), body.positions_t0(), body.positions_t0()});
    return tree;
}

}  // namespace

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

Crossing mark_crossing(Stage& stage, const World& world)
{
    const Body &first = *world.bodies[0], &second = *world.bodies[1];
    const FaceTree tree_a = fitted_tree(first), tree_b = fitted_tree(second);
    const StillSurface a{first.surface(), first.positions_t0(), tree_a},
        b{second.surface(), second.positions_t0(), tree_b};
    const Intersection intersection = trace_intersection(a, b);
    const SurfaceRegions of_first = flood_regions(intersection.piercings, a, b, true),
                         of_second = flood_regions(intersection.piercings, a, b, false);
    stage.bodies[0].opacity = 0.35;
    stage.bodies[1].opacity = 0.75;
    draw_curves(stage, intersection, a, b);
    Crossing crossing;
    crossing.curves = intersection.curves.size();
    crossing.piercings = intersection.piercings.size();
    crossing.regions = of_second.winding.size();
    crossing.first_inside = mark_inside(stage, of_first, a, palette::colliding_face);
    crossing.second_inside = mark_inside(stage, of_second, b, palette::artefact);
    return crossing;
}

}  // namespace enduring::chapter09
