#include "chapters/12_joints/experiments/experiments.hpp"
#include "chapters/12_joints/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/run.hpp"
#include "common/scenes/scene.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter12 {

/// Two fingers lift a box by friction alone: how far it slips through them, as a film.
void gripper(const RunOptions& options, Report& report)
{
    Scene scene = load_scene(scene_file("gripper"));
    ClipProbe film(scene, report.file("gripper.webp"), options.quick ? 4 : 20, 480, 400);
    const World& world = scene.world;
    double held = 0, slip = 0;
    WatchProbe watch([&](const World&, const Contacts&, double dt) {
        const double above = body_named(world, "hand").centre().y() - body_named(world, "box").centre().y();
        if (world.time < 0.3 + dt / 2)  // the fingers close
            held = above;
        slip = std::max(slip, std::abs(above - held));
    });
    run(scene, chapter12_solver(scene.contact), {&film, &watch});
    film.finish();
    report.fact("gripper", "slip_um", 1e6 * slip, 2);
    report.fact("gripper", "lifted_m", body_named(world, "box").centre().y() - 0.1, 3);
}

}  // namespace enduring::chapter12
