#include "chapters/08_deep_contacts/experiments/experiments.hpp"
#include "chapters/08_deep_contacts/experiments/random_overlaps.hpp"
#include "chapters/08_deep_contacts/solver.hpp"
#include "chapters/08_deep_contacts/surface_regions.hpp"
#include "chapters/motivating_scenes/buried_vertex.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/run/run.hpp"

namespace enduring::chapter08 {
namespace {

StillSurface still(const Body& body, FaceTree& tree)
{
    tree = FaceTree(body.surface(), body.positions_t0());
    tree.refit({body.surface(), body.positions_t0(), body.positions_t0()});
    return {body.surface(), body.positions_t0(), tree};
}

void draw_curve(Stage& stage, const Intersection& intersection, const IntersectionCurve& curve,
                const StillSurface& a, const StillSurface& b)
{
    const auto point = [&](std::size_t i) {
        return point_of(intersection.piercings[curve.piercings[i % curve.piercings.size()]], a, b);
    };
    for (std::size_t i = 0; i < curve.piercings.size(); ++i)
        stage.segments.push_back({point(i), point(i + 1), palette::colliding_vertex, 3.5});
}

/// Dots at the vertices in the other body; returns how many.
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

/// Lets the bunny out of the wall: how fast its middle is at most, and how many of its vertices are left in
/// it.
void let_out(Scene& scene, const RunOptions& options, Report& report)
{
    double fastest = 0;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        fastest = std::max(fastest, world.bodies[1]->mean_velocity().norm());
    });
    StripProbe film(
        scene, {0, 0.05, 0.1, 0.2}, [](auto&&...) {}, 400, 270);
    run(scene, chapter08_solver(scene.contact), {&watch, &film},
        failure_on_purpose({.steps = options.quick ? 41 : 400}));
    long left = 0;
    for (const Vec3& x : scene.world.bodies[1]->positions_t0())
        left += motivating::depth_inside(*scene.world.bodies[0], x) > 1e-3;
    write_png(film.all(2), report.file("bunny_out.png"));
    report.fact("bunny_curve", "fastest", fastest, 3);
    report.fact("bunny_curve", "left", static_cast<double>(left), 5);
}

}  // namespace

/// The scene of chapter 6's film with the bunny pushed into the bowl, before anything moves.
void bunny_curve(const RunOptions& options, Report& report)
{
    Scene scene = load_scene(scene_file("bunny_bowl"), R"({
        "/bodies/bunny/position": [0.3, 0.12, 0.1],
        "camera": {"eye": [1.5, 1.15, 2.5], "target": [0.2, 0.5, 0.05], "field_of_view_deg": 30}})");
    const World& world = scene.world;
    FaceTree tree_a, tree_b;
    const StillSurface a = still(*world.bodies[0], tree_a), b = still(*world.bodies[1], tree_b);
    const Intersection intersection = trace_intersection(a, b);
    Stage stage = stage_of(world, scene);
    for (Drawable& body : stage.bodies)
        body.opacity = 0.45;
    for (const IntersectionCurve& curve : intersection.curves)
        draw_curve(stage, intersection, curve, a, b);
    const auto of_bowl = flood_regions(intersection.piercings, a, b, true);
    const auto of_bunny = flood_regions(intersection.piercings, a, b, false);
    const long bowl_inside = mark_inside(stage, of_bowl, a, palette::colliding_face);
    const long bunny_inside = mark_inside(stage, of_bunny, b, palette::artefact);
    write_png(Renderer(720, 480).draw(stage), report.file("bunny_curve.png"));
    report.fact("bunny_curve", "curves", static_cast<double>(intersection.curves.size()));
    report.fact("bunny_curve", "piercings", static_cast<double>(intersection.piercings.size()), 5);
    report.fact("bunny_curve", "bowl_inside", static_cast<double>(bowl_inside), 5);
    report.fact("bunny_curve", "bunny_inside", static_cast<double>(bunny_inside), 5);
    report.fact("bunny_curve", "bunny_regions", static_cast<double>(of_bunny.winding.size()), 5);
    let_out(scene, options, report);
}

}  // namespace enduring::chapter08
