#include "chapters/09_deep_contacts/experiments/draw_crossing.hpp"
#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/experiments/inside_scenes.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "chapters/motivating_scenes/buried_vertex.hpp"
#include "common/experiments/render/moments.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>

namespace enduring::chapter09 {
namespace {

const Vec3 seen_from(1.3, 0.9, 2.45);  ///< direction to the camera

/// Vertices of the bunny that are more than 1 mm deep in the bowl.
long left_inside(const World& world)
{
    const auto x = world.bodies[1]->positions_t0();
    return std::count_if(x.begin(), x.end(), [&](const Vec3& vertex) {
        return motivating::depth_inside(*world.bodies[0], vertex) > 1e-3;
    });
}

/// Lets the bunny out of the wall: how fast its middle is until it is out, and how many of its vertices are
/// left.
void separate(Scene& scene, const RunOptions& options, Report& report)
{
    double fastest = 0;
    bool out = false;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        out = out || left_inside(world) == 0;
        fastest = std::max(fastest, out ? 0 : world.bodies[1]->mean_velocity().norm());
    });
    const MarkContacts mark = [](Stage& stage, const World& world, const Contacts&) {
        mark_crossing(stage, world);
    };
    // the two seconds of a full run are ten of the clip
    ClipProbe clip(scene, report.file("bunny_out.webp"), options.quick ? 4 : 20, 480, 320,
                   {.slow_motion = 5, .mark = mark});
    MomentsProbe pictures(scene, {0, 0.1, 0.2, 0.4}, mark);
    run(scene, chapter09_solver(scene.contact), {&watch, &pictures, &clip},
        failure_on_purpose({.steps = options.quick ? 81 : 400}));
    clip.finish();
    std::vector<Moment> moments = pictures.moments();
    frame_together(moments, seen_from, 4.0 / 3);
    write_png(draw_moments(moments, 2, 480, 360), report.file("bunny_out.png"));
    report.fact("bunny_curve", "fastest", fastest, 3);
    report.fact("bunny_curve", "after_s", scene.world.time, 2);
    report.fact("bunny_curve", "left", static_cast<double>(left_inside(scene.world)), 5);
}

}  // namespace

/// The scene of chapter 6's film with the bunny pushed into the bowl, before anything moves.
void bunny_curve(const RunOptions& options, Report& report)
{
    Scene scene = bunny_in_wall();
    Stage stage = stage_of(scene.world, scene);
    const Crossing crossing = mark_crossing(stage, scene.world);
    stage.camera = frame(points_of(stage), seen_from, 3.0 / 2, 0.04);
    scene.camera = {stage.camera.eye, stage.camera.target, stage.camera.field_of_view_deg};
    write_png(Renderer(720, 480).draw(stage), report.file("bunny_curve.png"));
    report.fact("bunny_curve", "curves", static_cast<double>(crossing.curves));
    report.fact("bunny_curve", "piercings", static_cast<double>(crossing.piercings), 5);
    report.fact("bunny_curve", "bowl_inside", static_cast<double>(crossing.first_inside), 5);
    report.fact("bunny_curve", "bunny_inside", static_cast<double>(crossing.second_inside), 5);
    report.fact("bunny_curve", "bunny_regions", static_cast<double>(crossing.regions), 5);
    separate(scene, options, report);
}

}  // namespace enduring::chapter09
