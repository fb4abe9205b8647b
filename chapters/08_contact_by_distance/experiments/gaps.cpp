#include "chapters/08_contact_by_distance/experiments/gaps.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/formula_runs.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/render/moments.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/polygon_triangles.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace enduring::chapter08 {
namespace {

constexpr double pitch = 0.02, tall = 0.03, back = 0.02, deep = 0.04;  ///< of a comb [m]
constexpr int teeth = 5;

/// A comb with its teeth up, between x = 0 and x = 0.1, its back below y = 0.
SurfaceMesh comb(double tooth)
{
    std::vector<std::pair<double, double>> outline{{0, -back}, {teeth * pitch, -back}};
    for (int i = teeth - 1; i >= 0; --i) {
        const double left = i * pitch + 0.5 * (pitch - tooth), right = left + tooth;
        outline.insert(outline.end(), {{right, 0}, {right, tall}, {left, tall}, {left, 0}});
        if (i == teeth - 1)
            outline.insert(outline.end() - 4, {teeth * pitch, 0});
    }
    outline.emplace_back(0, 0);
    const long n = static_cast<long>(outline.size());
    std::vector<Vec3> vertices;
    for (const double z : {0.5 * deep, -0.5 * deep})
        for (const auto& [x, y] : outline)
            vertices.emplace_back(x, y, z);
    std::vector<std::vector<long>> polygons(2);
    for (long i = 0; i < n; ++i) {
        polygons[0].push_back(i);
        polygons[1].push_back(2 * n - 1 - i);
        polygons.push_back({i, i + n, (i + 1) % n + n, (i + 1) % n});
    }
    return surface_from_polygons(vertices, polygons,
                                 [](long, const std::string& reason) { throw std::logic_error(reason); });
}

SurfaceMesh placed(SurfaceMesh mesh, const Vec3& by, const Quaternion& turn = Quaternion::Identity())
{
    for (Vec3& x : mesh.vertices)
        x = turn * x + by;
    return mesh;
}

void add(Scene& scene, const std::string& name, const SurfaceMesh& mesh, bool held,
         const Vec3& velocity = Vec3::Zero())
{
    if (held)
        scene.world.bodies.push_back(std::make_unique<StaticBody>(
            name, SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
    else
        scene.world.bodies.push_back(
            std::make_unique<RigidBody>(name, mesh, mass_properties(mesh, 1000), velocity));
}

}  // namespace

Scene scene_of(const Combs& combs)
{
    Scene scene = chapter07::scene_of({}, combs.dt);
    scene.world.planes.clear();
    const SurfaceMesh lower = comb(0.5 * pitch - combs.play);
    // upside down: its teeth hang between those of the lower one, half a pitch beside them
    const Quaternion turn(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ()));
    const SurfaceMesh upper = placed(lower, Vec3((teeth + 0.5) * pitch, tall + combs.rise, 0), turn);
    add(scene, "lower", lower, combs.lower_held);
    add(scene, "upper", upper, false, combs.velocity);
    return scene;
}

Scene plates_apart(double gap, double dt)
{
    Scene scene = chapter07::scene_of({}, dt);
    scene.world.planes.clear();
    const Quaternion lean(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
    add(scene, "lower", placed(box({0.1, 0.02, 0.1}), lean * Vec3(0, -0.01, 0), lean), false);
    add(scene, "upper", placed(box({0.1, 0.02, 0.1}), lean * Vec3(0, 0.01 + gap, 0), lean), false);
    return scene;
}

GapRun run_gap(Scene scene, int steps)
{
    GapRun result;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) { result.newton_steps += record.newton_steps; };
    const Solver solver = chapter08_solver(scene.contact, settings);
    const Body& upper = *scene.world.bodies.back();
    const Vec3 start = upper.centre(), velocity = upper.mean_velocity(), down = scene.world.gravity;
    Contacts contacts;
    for (int i = 0; i < steps; ++i) {
        advance(scene.world, contacts, solver, scene.dt);
        for (const Contact& contact : contacts)
            result.pushed += contact.impulse.norm() + contact.friction.norm();
    }
    const double time = steps * scene.dt;
    const Vec3 expected = start + time * velocity + 0.5 * time * (time + scene.dt) * down;
    result.pushed /= upper.mass() * earth * time;
    result.off_fall = (upper.centre() - expected).norm() / upper.size();
    result.aside = std::hypot(upper.mean_velocity().x() - velocity.x(),
                              upper.mean_velocity().z() - velocity.z());
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

}  // namespace

/// Thin gaps: nothing touches, and nothing pushes.
void gaps(const RunOptions& options, Report& report)
{
    const std::vector<double> plays = options.quick ? std::vector{2e-3, 4e-4, 1e-6}
                                                    : std::vector{2e-3, 1e-3, 4e-4, 1e-4, 1e-5, 1e-6};
    const std::vector<double> lengths = options.quick ? std::vector{0.01, 0.04}
                                                      : std::vector{0.001, 0.0025, 0.01, 0.02, 0.04};
    Table table({"scene", "gap_mm", "dt_ms", "pushed", "off_free_fall", "newton_steps"});
    double pushed = 0, off = 0;
    for (const double play : plays)
        for (const double dt : lengths) {
            constexpr int steps = 20;
            const Vec3 along(0, 0, 0.3);
            const auto tell = [&](const std::string& name, Scene scene) {
                const GapRun run = run_gap(std::move(scene), steps);
                table.add({name, 1e3 * play, 1e3 * dt, run.pushed, run.off_fall, run.newton_steps});
                pushed = std::max(pushed, run.pushed);
                off = std::max(off, run.off_fall);
            };
            tell("combs fall together", scene_of(Combs{.play = play, .dt = dt}));
            Scene sliding = scene_of(Combs{.play = play, .dt = dt, .lower_held = true, .velocity = along});
            sliding.world.gravity.setZero();
            tell("a comb slides along another", std::move(sliding));
            tell("plates fall together", plates_apart(play, dt));
        }
    report.table("gaps", table);
    report.page_table("gaps", table, 3);
    report.fact("gaps", "runs", static_cast<double>(table.rows().size()));
    report.fact("gaps", "pushed", pushed, 2);
    report.fact("gaps", "off_fall", off, 2);
    if (options.pictures)
        draw_combs(report);
}

}  // namespace enduring::chapter08
