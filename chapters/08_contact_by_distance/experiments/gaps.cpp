#include "chapters/08_contact_by_distance/experiments/gaps.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/bolt.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/formula_runs.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/render/moments.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace enduring::chapter08 {

Scene bolt_apart(double play, double dt)
{
    // as many facets as the nut has, so that they stay parallel, and as far from both flanks
    BoltInNut bolt{.bolt_segments = 96, .dt = dt, .play = play, .nut_held = false};
    bolt.above = (1 + bolt.thread.flank) * play;
    return scene_of(bolt);
}

GapRun run_gap(Scene scene, int steps)
{
    GapRun result;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) { result.newton_steps += record.newton_steps; };
    const Solver solver = chapter08_solver(scene.contact, settings);
    const auto& bodies = scene.world.bodies;
    std::vector<Vec3> starts, velocities;
    for (const auto& body : bodies) {
        starts.push_back(body->centre());
        velocities.push_back(body->mean_velocity());
    }
    Contacts contacts;
    for (int i = 0; i < steps; ++i) {
        advance(scene.world, contacts, solver, scene.dt);
        for (const Contact& contact : contacts)
            result.pushed += contact.impulse.norm() + contact.friction.norm();
    }
    const double time = steps * scene.dt;
    result.pushed /= bodies.back()->mass() * formula_runs::earth * time;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Body& body = *bodies[i];
        if (body.is_static())
            continue;
        const Vec3 fallen = starts[i] + time * velocities[i] +
                            0.5 * time * (time + scene.dt) * scene.world.gravity,
                   faster = body.mean_velocity() - velocities[i];
        result.off_fall = std::max(result.off_fall, (body.centre() - fallen).norm() / body.size());
        result.aside = std::max(result.aside, std::hypot(faster.x(), faster.z()));
    }
    return result;
}

namespace {

/// Two combs that fall together, with 0.4 mm of play, and one that lands on the back of the other.
void draw_combs(Report& report)
{
    Scene scene = scene_of(Combs{.play = 4e-4, .dt = 0.01});
    MomentsProbe probe(scene, {0.0, 0.2}, mark_pairs, "fall together, ");
    chapter07::watch(scene, 0.22, chapter08_solver, &probe);
    Scene held = scene_of(Combs{.play = 4e-4, .dt = 0.01, .lower_held = true});
    MomentsProbe landed(held, {0.3}, mark_pairs, "the lower one is held, ");
    chapter07::watch(held, 0.32, chapter08_solver, &landed);
    std::vector<Moment> moments = probe.moments();
    moments.insert(moments.end(), landed.moments().begin(), landed.moments().end());
    constexpr int width = 420, height = 380;
    frame_each(moments, Vec3(0.25, 0.3, 1), static_cast<double>(width) / height);
    write_png(draw_moments(moments, 3, width, height), report.file("gaps.png"));
}

struct Named {
    std::string name;
    Scene scene;
};

/// All scenes in which nothing touches and so nothing may push.
std::vector<Named> scenes_apart(double play, double dt)
{
    std::vector<Named> all;
    all.push_back({"combs fall together", scene_of(Combs{.play = play, .dt = dt})});
    const Vec3 along(0, 0, 0.3);
    Scene sliding = scene_of(Combs{.play = play, .dt = dt, .lower_held = true, .velocity = along});
    sliding.world.gravity.setZero();
    all.push_back({"a comb slides along another", std::move(sliding)});
    all.push_back({"plates fall together", plates_apart(play, dt)});
    all.push_back({"cups fall together", cups_apart(play, dt)});
    all.push_back({"links of a chain fall together", links_apart(play, dt)});
    all.push_back({"paper falls together", paper_apart(play, dt)});
    all.push_back({"gears fall together", gears_apart(play, dt)});
    if (play >= least_bolt_play && play <= most_bolt_play)
        all.push_back({"bolt and nut fall together", bolt_apart(play, dt)});
    return all;
}

}  // namespace

/// Thin gaps: nothing touches, and nothing pushes.
void gaps(const RunOptions& options, Report& report)
{
    const std::vector<double> plays = options.quick ? std::vector{2e-3, 4e-4, 1e-6}
                                                    : std::vector{2e-3, 1e-3, 4e-4, 1e-4, 1e-5, 1e-6};
    const std::vector<double> lengths = options.quick ? std::vector{0.01, 0.04}
                                                      : std::vector{0.001, 0.0025, 0.01, 0.02, 0.04};
    Table table({"scene", "gap_mm", "dt_ms", "pushed", "off_free_fall", "newton_steps"});
    double pushed = 0, off = 0, sheets_off = 0;
    long runs = 0;  // without those of open sheets
    for (const double play : plays)
        for (const double dt : lengths) {
            const auto run = [&](const std::string& name, Scene scene) {
                constexpr int steps = 20;
                const GapRun found = run_gap(std::move(scene), steps);
                table.add({name, 1e3 * play, 1e3 * dt, found.pushed, found.off_fall, found.newton_steps});
                return found;
            };
            for (auto& [name, scene] : scenes_apart(play, dt)) {
                const GapRun found = run(name, std::move(scene));
                pushed = std::max(pushed, found.pushed);
                off = std::max(off, found.off_fall);
                ++runs;
            }
            // they have no inner surface, so the last of their skins is pushed out of each other
            sheets_off = std::max(sheets_off,
                                  run("open sheets fall together", sheets_apart(play, dt)).off_fall);
        }
    report.table("gaps", table);
    report.page_table("gaps", table, 3);
    report.fact("gaps", "runs", static_cast<double>(runs));
    report.fact("gaps", "pushed", pushed, 2);
    report.fact("gaps", "off_fall", off, 2);
    report.fact("gaps", "sheets_off", sheets_off, 2);
    if (options.pictures)
        draw_combs(report);
}

}  // namespace enduring::chapter08
