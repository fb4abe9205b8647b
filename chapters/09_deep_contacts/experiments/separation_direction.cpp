#include "chapters/09_deep_contacts/experiments/draw_crossing.hpp"
#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/experiments/overlap_shape.hpp"
#include "chapters/09_deep_contacts/overlaps.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/geometry/box_shapes.hpp"

#include <Eigen/Geometry>

#include <numbers>

namespace enduring::chapter09 {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A leaning cube whose corner hangs over the rim of a block.
SurfaceMesh leaning_cube(const Vec3& middle)
{
    SurfaceMesh mesh = box({1, 1, 1}, {3, 3, 3});
    const Eigen::Quaterniond turn = Eigen::AngleAxisd(20 * degree, Vec3::UnitY()) *
                                    Eigen::AngleAxisd(35 * degree, Vec3::UnitZ());
    for (Vec3& x : mesh.vertices)
        x = turn * x + middle;
    return mesh;
}

Drawable drawn(const SurfaceMesh& mesh, const Vec3& color)
{
    Drawable drawable;
    drawable.positions = mesh.vertices;
    drawable.faces = mesh.faces;
    drawable.color = color;
    drawable.wireframe = true;
    drawable.opacity = 0.45;
    return drawable;
}

}  // namespace

/// A cube over the rim of a block: the curve, what it bounds on each, and the way out.
void separation_direction(const RunOptions&, Report& report)
{
    const Vec3 middle(0.8, 0.5, 0.3);
    const SurfaceMesh cube = leaning_cube(middle), block = box({2, 0.8, 2}, {5, 2, 5});
    const OverlapShape a(cube), b(block);
    const Intersection intersection = trace_intersection(a.still(), b.still());
    const std::vector<Overlap> overlaps = find_overlaps(a.still(), b.still());
    Stage stage;
    stage.bodies = {drawn(cube, palette::blue), drawn(block, palette::sand)};
    draw_curves(stage, intersection, a.still(), b.still());
    mark_inside(stage, flood_regions(intersection.piercings, a.still(), b.still(), true), a.still(),
                palette::artefact);
    mark_inside(stage, flood_regions(intersection.piercings, a.still(), b.still(), false), b.still(),
                palette::colliding_face);
    for (const Overlap& overlap : overlaps)
        stage.segments.push_back(
            {middle, middle + 0.9 * overlap.separation_direction, palette::ink, 5, true});
    stage.camera.eye = {2.6, 1.9, 3.2};
    stage.camera.target = {0.25, 0.3, 0};
    stage.camera.field_of_view_deg = 38;
    write_png(Renderer(720, 480).draw(stage), report.file("separation_direction.png"));
    report.fact("separation_direction", "overlaps", static_cast<double>(overlaps.size()));
    const Vec3 way = overlaps.empty() ? Vec3(Vec3::Zero()) : overlaps[0].separation_direction;
    report.fact("separation_direction", "up", way.y(), 2);
    report.fact("separation_direction", "aside", way.x(), 2);
}

}  // namespace enduring::chapter09
