#include "chapters/engines/cases.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/swings.hpp"
#include "chapters/09_deep_contacts/experiments/thin_shots.hpp"
#include "chapters/engines/judge.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

namespace enduring::engines {
namespace {

using Measures = std::vector<Measure>;

Scene lasting(Scene scene, const std::string& name, double duration)
{
    scene.name = name;
    scene.duration = duration;
    return scene;
}

/// Cubes on one another that should stay where they are.
Case stack(bool quick)
{
    return {"stack", "ten cubes of 1 m, each turned by 7 degrees: do they rest?", 1,
            [=](int) {
                return lasting(chapter07::scene_of(chapter07::stack_of(10), 0.01), "stack", quick ? 1 : 6);
            },
            [](int, const EngineScene& scene, const Trajectory& run) {
                const double depth = depth_um(scene, run.back()), drift = drift_um_per_s(scene, run);
                const bool stands = moved_mm(run) < 50;
                return Measures{{"depth_um", depth, stands && depth < 1000},
                                {"drift_um_per_s", drift, stands && drift < 1000}};
            }};
}

/// A cube of so many times their mass on two others.
Case mass_ratio(double ratio)
{
    const std::string name = "ratio_" + std::to_string(std::lround(ratio));
    return {name, "a heavy cube on two light ones: how far does it sink?", 1,
            [=](int) {
                return lasting(chapter07::scene_of(chapter07::stack_of(3, 10, 10 * ratio), 0.01), name, 4);
            },
            [](int, const EngineScene&, const Trajectory& run) {
                const double sunk = 1e3 * (2.5 - run.back().poses.back().position.y());
                return Measures{{"sunk_mm", sunk, std::abs(sunk) < 1 && moved_mm(run) < 10}};
            }};
}

Case heap()
{
    return {"heap", "a hundred cubes dropped on a heap: do they rest after 10 s?", 1,
            [](int) {
                return lasting(chapter07::scene_of(chapter07::loose_cubes(100, 4, 1), 1.0 / 60), "heap", 10);
            },
            [](int, const EngineScene& scene, const Trajectory& run) {
                const Trajectory later(run.begin() + static_cast<std::ptrdiff_t>(5 * run.size() / 6),
                                       run.end());
                const double depth = depth_um(scene, run.back()), drift = drift_um_per_s(scene, later);
                return Measures{{"depth_um", depth, depth < 1000}, {"drift_um_per_s", drift, drift < 1000}};
            }};
}

/// Without friction and without a facet too coarse to matter, the swing should come back to where it began.
Case swing(const std::string& name, const std::string& hollow, const std::function<chapter08::Swing()>& make)
{
    return {name, "a block swings in " + hollow + " without friction: what part of its amplitude is kept?", 1,
            [=](int) {
                chapter08::Swing swing = make();
                const double period = chapter08::pendulum_period(swing, swing.amplitude);
                return lasting(std::move(swing.scene), name, 1.4 * period);
            },
            [](int, const EngineScene&, const Trajectory& run) {
                const double kept = amplitude_kept(run, 1);
                return Measures{{"kept", kept, std::abs(kept - 1) < 0.05}};
            }};
}

Case pipe(int facets)
{
    return swing("pipe_" + std::to_string(facets), "a half pipe",
                 [=] { return chapter08::block_in_pipe(facets, 0.01); });
}

/// A hollow that bends both ways, as a bowl does.
Case torus()
{
    return swing("torus", "an upright torus", [] { return chapter08::block_in_torus(120, 0.01); });
}

Case arch()
{
    return {"arch", "an arch of twenty stones without mortar: how far does a stone move?", 1,
            [](int) { return lasting(chapter07::arch(20, 5, 0.01), "arch", 5); },
            [](int, const EngineScene&, const Trajectory& run) {
                const double moved = moved_mm(run);
                return Measures{{"moved_mm", moved, moved < 10}};
            }};
}

/// Bricks edge on edge, every other layer a little farther on.
Case wall()
{
    const auto make = [](int) {
        std::vector<chapter07::Box> bricks;
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 5; ++x)
                bricks.push_back({.centre = Vec3(2 * x + 0.8 * (y % 2), y + 0.5, 0), .size = Vec3(2, 1, 1)});
        return lasting(chapter07::scene_of(bricks, 0.01), "wall", 5);
    };
    return {"wall", "a wall of thirty bricks, edge on edge: how far does a brick move?", 1, make,
            [](int, const EngineScene&, const Trajectory& run) {
                const double moved = moved_mm(run);
                return Measures{{"moved_mm", moved, moved < 10}};
            }};
}

struct SlopeRun {
    double mu, angle_deg;
    double angle() const { return angle_deg * std::numbers::pi / 180; }
    double acceleration() const  ///< by Coulomb's law [m/s^2]
    {
        return 9.81 * std::max(0.0, std::sin(angle()) - mu * std::cos(angle()));
    }
};
constexpr std::array<SlopeRun, 4> slope_runs{{{0, 10}, {0.3, 15}, {0.3, 20}, {0.6, 35}}};

/// A block at rest on a slab of triangles.
Scene block_on_slab(const SlopeRun& asked)
{
    Scene scene = chapter07::scene_of(std::vector<chapter07::Box>{}, 0.01, 0, asked.mu, asked.mu);
    scene.world.planes.clear();
    const SurfaceMesh slab = slope({12, 0.5, 3}, asked.angle(), {16, 1, 5});
    SurfaceMesh block = box({0.5, 0.2, 0.5});
    const Eigen::AngleAxisd turn(asked.angle(), Vec3::UnitZ());
    for (Vec3& x : block.vertices)
        x = turn * (x + Vec3(4, 0.1 + 1e-5, 0.13));
    scene.world.bodies.push_back(std::make_unique<StaticBody>(
        "slab", SurfaceTopology(static_cast<int>(slab.vertices.size()), slab.faces), slab.vertices));
    scene.world.bodies.push_back(std::make_unique<RigidBody>("block", block, mass_properties(block, 1000)));
    return lasting(std::move(scene), "slopes", 1.5);
}

Case slopes()
{
    return {
        "slopes",
        "a block on slopes of triangles: how far is its acceleration from Coulomb's law, in percent of g?",
        static_cast<int>(slope_runs.size()),
        [](int run) { return block_on_slab(slope_runs.at(static_cast<std::size_t>(run))); },
        [](int number, const EngineScene& scene, const Trajectory& run) {
            const SlopeRun& asked = slope_runs.at(static_cast<std::size_t>(number));
            const Vec3 down(-std::cos(asked.angle()), -std::sin(asked.angle()), 0);
            const double error = std::abs(acceleration(scene, run, 1, down) - asked.acceleration()) / 9.81;
            return Measures{{"error_percent", 100 * error, error < 0.01}};
        }};
}

Case overlap()
{
    return {"overlap", "a block begins 10 cm deep in a floor: how fast is it thrown, and where does it end?",
            1, [](int) { return load_scene(scene_file("initial_overlap")); },
            [](int, const EngineScene& scene, const Trajectory& run) {
                const double thrown = thrown_m_per_s(scene, run), depth = depth_um(scene, run.back());
                const bool lies = std::abs(run.back().poses[1].position.y() - 0.2) <
                                  0.01;  // on a face, on the floor
                return Measures{{"thrown_m_per_s", thrown, thrown < 1 && lies},
                                {"depth_um", depth, depth < 1000 && lies}};
            }};
}

/// The same shots every time: bodies in turn, at a plate of two triangles a side.
chapter09::ThinShot shot(int number)
{
    const auto& bodies = chapter09::thin_shots();
    std::mt19937_64 random(static_cast<unsigned>(number + 1));
    return chapter09::shot_at_random(chapter09::thin_targets()[0],
                                     bodies[static_cast<std::size_t>(number) % bodies.size()], random);
}

Case thin_plate()
{
    return {"thin", "twelve shots at a plate of 12 mm: how many come through?", 12,
            [](int run) { return shot(run).scene; },
            [](int number, const EngineScene& scene, const Trajectory& run) {
                const bool through = is_through(shot(number), world_at(scene, run.back()));
                return Measures{{"through_count", through ? 1.0 : 0.0, !through}};
            }};
}

bool is_count(const std::string& quantity) { return quantity.ends_with("_count"); }

void add(Measures& all, const Measures& next)
{
    if (all.empty()) {
        all = next;
        return;
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].value = is_count(all[i].quantity) ? all[i].value + next[i].value
                                                 : std::max(all[i].value, next[i].value);
        all[i].right = all[i].right && next[i].right;
    }
}

/// Nothing moves: what the case asks then, wrong in all of it.
Measures wrong_measures(const Case& asked, int run, const EngineScene& scene)
{
    Frame start;
    for (const EngineBody& body : scene.bodies)
        start.poses.push_back(body.frame);
    Measures measures = asked.judge(run, scene, Trajectory(60, start));
    for (Measure& measure : measures)
        measure = {measure.quantity, is_count(measure.quantity) ? 1 : INFINITY, false};
    return measures;
}

}  // namespace

std::vector<Case> all_cases(bool quick)
{
    if (quick)
        return {stack(true), slopes(), overlap()};
    return {stack(false), mass_ratio(1000), mass_ratio(5000), pipe(120), pipe(480),    torus(),
            arch(),       wall(),           slopes(),         overlap(), thin_plate(), heap()};
}

const Case& case_named(const std::vector<Case>& cases, const std::string& name)
{
    const auto found = std::find_if(cases.begin(), cases.end(),
                                    [&](const Case& one) { return one.name == name; });
    if (found == cases.end())
        throw std::out_of_range("no case " + name);
    return *found;
}

Verdict try_case(const Case& asked, const Engine& engine, const Way& way)
{
    Verdict verdict;
    for (int number = 0; number < asked.runs; ++number) {
        Scene scene = asked.make(number);
        const EngineScene described = describe(scene);
        const int steps = static_cast<int>(std::lround(scene.duration / scene.dt));
        try {
            const Trajectory run = engine.run(std::move(scene), way, steps);
            add(verdict.measures, is_finite(run) ? asked.judge(number, described, run)
                                                 : wrong_measures(asked, number, described));
            verdict.ms = std::max(verdict.ms, ms_at_rest(run));
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s, %s: %s\n", engine.name.c_str(), asked.name.c_str(), error.what());
            add(verdict.measures, wrong_measures(asked, number, described));
        }
    }
    return verdict;
}

}  // namespace enduring::engines
