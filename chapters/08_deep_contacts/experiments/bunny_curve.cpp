#include "chapters/08_deep_contacts/experiments/draw_crossing.hpp"
#include "chapters/08_deep_contacts/experiments/experiments.hpp"
#include "chapters/08_deep_contacts/experiments/random_overlaps.hpp"
#include "chapters/08_deep_contacts/solver.hpp"
#include "chapters/motivating_scenes/buried_vertex.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>

namespace enduring::chapter08 {
namespace {

StillSurface still(const Body& body, FaceTree& tree)
{
    tree = FaceTree(body.surface(), body.positions_t0());
    tree.refit({body.surface(), body.positions_t0(), body.positions_t0()});
    return {body.surface(), body.positions_t0(), tree};
}

/// Vertices of the bunny that are more than 1 mm deep in the bowl.
long left_inside(const World& world)
{
    const auto x = world.bodies[1]->positions_t0();
    return std::count_if(x.begin(), x.end(), [&](const Vec3& vertex) {
        return motivating::depth_inside(*world.bodies[0], vertex) > 1e-3;
    });
}

/// Lets the bunny out of the wall: how fast its middle is until it is out, and how many of its vertices are left.
void let_out(Scene& scene, const RunOptions& options, Report& report)
{
    double fastest = 0;
    bool out = false;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        out = out || left_inside(world) == 0;
        fastest = std::max(fastest, out ? 0 : world.bodies[1]->mean_velocity().norm());
    });
    StripProbe film(
        scene, {0, 0.05, 0.1, 0.2}, [](auto&&...) {}, 400, 270);
    run(scene, chapter08_solver(scene.contact), {&watch, &film},
        failure_on_purpose({.steps = options.quick ? 41 : 400}));
    write_png(film.all(2), report.file("bunny_out.png"));
    report.fact("bunny_curve", "fastest", fastest, 3);
    report.fact("bunny_curve", "after_s", scene.world.time, 2);
    report.fact("bunny_curve", "left", static_cast<double>(left_inside(scene.world)), 5);
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
    draw_curves(stage, intersection, a, b);
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
