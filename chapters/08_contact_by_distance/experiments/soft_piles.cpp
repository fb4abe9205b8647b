#include "chapters/08_contact_by_distance/experiments/soft_piles.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/render/moments.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/input/number_text.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>

namespace enduring::chapter08 {
namespace {

DeformableSettings settings_of(double density, double young, const Vec3& position)
{
    DeformableSettings settings;
    settings.material.density = density;
    settings.material.young = young;
    settings.material.poisson = 0.3;
    settings.material.stiffness_damping = 0.005;
    settings.position = position;
    settings.impulse_response = ImpulseResponse::implicit;
    return settings;
}

struct SoftOutcome {
    chapter07::PileOutcome pile;
    double deepest_ever_mm = 0;  ///< after any step, whatever the pairs say
    long inverted = 0;           ///< elements, the most after any step
};

SoftOutcome run_soft(Scene& scene, double duration, Probe* observer)
{
    SoftOutcome outcome;
    WatchProbe all([&](const World& world, const Contacts& contacts, double dt) {
        outcome.deepest_ever_mm = std::max(outcome.deepest_ever_mm, 1e3 * chapter07::true_depth(world));
        long inverted = 0;
        for (const auto& body : world.bodies)
            inverted += body->inverted_elements();
        outcome.inverted = std::max(outcome.inverted, inverted);
        if (observer)
            observer->observe(world, contacts, dt);
    });
    outcome.pile = chapter07::watch(scene, duration, chapter08_solver, &all);
    return outcome;
}

}  // namespace

Scene sheet_over_ball(const Sheet& sheet)
{
    constexpr double side = 0.8, radius = 0.25;
    Scene scene = chapter07::scene_of({}, sheet.dt);
    SurfaceMesh ball = sphere(radius, 3);
    for (Vec3& vertex : ball.vertices)
        vertex += Vec3(0.013, 0.6, 0.007);  // under no vertex of the sheet
    scene.world.bodies.push_back(std::make_unique<StaticBody>(
        "ball", SurfaceTopology(static_cast<int>(ball.vertices.size()), ball.faces), ball.vertices));
    scene.world.bodies.push_back(std::make_unique<DeformableBody>(
        "sheet", bar(Vec3(side, sheet.thick, side), {sheet.cells, 1, sheet.cells}),
        settings_of(500, sheet.young, Vec3(0, 0.6 + radius + sheet.thick / 2 + 0.01, 0))));
    return scene;
}

Scene soft_stack(const SoftStack& stack)
{
    constexpr double side = 0.4, gap = 1e-3;
    Scene scene = chapter07::scene_of({}, stack.dt);
    for (int i = 0; i < stack.blocks; ++i)
        scene.world.bodies.push_back(std::make_unique<DeformableBody>(
            "block " + std::to_string(i + 1), bar(Vec3::Constant(side), {2, 2, 2}),
            settings_of(10 / (side * side * side), stack.young,
                        Vec3(0.01 * (i % 2), side / 2 + gap + (side + gap) * i, 0.007 * (i % 3)))));
    return scene;
}

/// Sheets over a ball, and stacks of soft blocks: depth, elements and energy.
void soft_piles(const RunOptions& options, Report& report)
{
    GrowingTable table(report, "soft_piles",
                       {"scene", "dt_s", "deepest_ever_mm", "deepest_mm", "drift_um_per_s", "max_inverted",
                        "energy_gain_j", "unconverged", "solves"},
                       options.quick ? 2 : 12);
    double deepest = 0, gain = 0, drift = 0;
    long inverted = 0;
    const auto add = [&](const std::string& name, Scene scene, double duration, Probe* observer = nullptr) {
        const SoftOutcome found = run_soft(scene, duration, observer);
        table.add({name, scene.dt, found.deepest_ever_mm, found.pile.deepest_mm, found.pile.drift_um_per_s,
                   found.inverted, found.pile.energy_gain_j, found.pile.solves.unconverged,
                   found.pile.solves.solves});
        deepest = std::max(deepest, found.deepest_ever_mm);
        gain = std::max(gain, found.pile.energy_gain_j);
        drift = std::max(drift, found.pile.drift_um_per_s);
        inverted = std::max(inverted, found.inverted);
    };
    for (const double dt : {0.01, 0.005})
        for (const double young : {2e5, 2e6})
            for (const int cells : {8, 14}) {
                if (options.quick && (cells > 8 || young > 1e6 || dt < 0.01))
                    continue;
                Scene scene = sheet_over_ball({cells, young, 0.02, dt});
                const bool shown = young < 1e6 && dt == 0.01 && cells == (options.quick ? 8 : 14);
                MomentsProbe pictures(scene, {0, 0.3, 0.95}, mark_pairs);
                add("sheet of " + std::to_string(cells) + " cells a side, " + readable(young / 1e6, 2) +
                        " MPa",
                    sheet_over_ball({cells, young, 0.02, dt}), options.quick ? 1.0 : 3.0,
                    shown ? &pictures : nullptr);
                if (!shown)
                    continue;
                std::vector<Moment> moments = pictures.moments();
                frame_each(moments, {0.7, 0.35, 1}, 1.2);
                write_png(draw_moments(moments, 3, 480, 400), report.file("soft_piles.png"));
            }
    for (const double dt : {0.01, 1.0 / 60})
        for (const double young : {1e5, 1e6}) {
            if (options.quick && (dt != 0.01 || young < 1e6))
                continue;
            const SoftStack stack{options.quick ? 3 : 5, young, dt};
            add("stack of " + std::to_string(stack.blocks) + " soft blocks, " + readable(young / 1e6, 2) +
                    " MPa",
                soft_stack(stack), options.quick ? 1.0 : 4.0);
        }
    report.table("soft_piles", table);
    report.page_table("soft_piles", table, 2);
    report.fact("soft_piles", "deepest_ever_mm", deepest, 2);
    report.fact("soft_piles", "gain_j", gain, 1);
    report.fact("soft_piles", "drift_um_per_s", drift, 2);
    report.fact("soft_piles", "max_inverted", static_cast<double>(inverted));
}

}  // namespace enduring::chapter08
