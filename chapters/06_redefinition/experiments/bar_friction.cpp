#include "chapters/06_redefinition/experiments/bar_friction.hpp"

#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/elements_of.hpp"
#include "common/experiments/run/run.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>

namespace enduring::chapter06 {
namespace {

Vec3 middle_of_cube(const World& world) { return body_named(world, "cube").centre(); }

}  // namespace

Scene scene_of(const FrictionCoefficients& mu, const std::string& basis)
{
    return load_scene(scene_file("bar_friction"),
                      R"({"contact": {"friction": {"mu_s": )" + shortest(mu.mu_s) + R"(, "mu_d": )" +
                          shortest(mu.mu_d) + R"(}}, "/bodies/bar/basis": ")" + basis + "\"}");
}

//! [drift]
RestOnBar rest_on_bar(Scene& scene, int settled, int steps, Table* moments, Probe* other)
{
    RestOnBar result;
    const double mu = std::get<MassSplitting>(scene.contact.friction).mu_s;
    Vec3 begin = Vec3::Zero(), anchor = Vec3::Zero();
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        const Vec3 now = middle_of_cube(world);
        if (world.step == 0)
            begin = now;
        if (world.step <= settled)
            anchor = now;
        result.way = (now - begin).norm();
        result.drift = std::max(result.drift, (now - anchor).norm());
        const Body& cube = body_named(world, "cube");
        if (moments != nullptr && world.step % 20 == 0)
            moments->add(
                {mu, world.time, now.x(), cube.linear_momentum().x() / cube.mass(), (now - anchor).norm()});
    });
    std::vector<Probe*> probes{&watch};
    if (other != nullptr)
        probes.push_back(other);
    RunLimits limits;
    limits.steps = steps;
    run(scene, chapter06_solver(scene.contact), probes, limits);
    return result;
}
//! [drift]

/// Thesis figure 7.16, its two pairs of coefficients as ours; beside it
/// the same on linear elements, without pictures.
void bar_friction(const RunOptions& options, Report& report)
{
    const int settled = options.quick ? 1500 : 5000, steps = options.quick ? 2000 : 20000;
    Table moments({"mu_static", "time_s", "x_m", "speed_m_per_s", "drift_m"});
    Table table({"elements", "mu_static", "mu_dynamic", "distance_m", "way_on_a_plane_m", "drift_m"});
    double worst = 0;
    for (const std::string basis : {"quadratic", "linear"})
        for (const FrictionCoefficients& mu : bar_coefficients) {
            const bool of_thesis = basis == "quadratic";
            Scene scene = scene_of(mu, basis);
            StripProbe strip(scene, {0.0, 0.15, steps * scene.dt}, mark_pairs, 560, 360);
            const double speed = 1.2, on_plane = speed * speed / (2 * 9.81 * mu.mu_d);
            const RestOnBar result = rest_on_bar(scene, settled, steps, of_thesis ? &moments : nullptr,
                                                 of_thesis ? &strip : nullptr);
            table.add(
                {elements_of(scene.world, "bar"), mu.mu_s, mu.mu_d, result.way, on_plane, result.drift});
            if (!of_thesis)
                continue;
            worst = std::max(worst, result.drift);
            report.fact("bar_friction", "elements", elements_of(scene.world, "bar"));
            if (&mu == &bar_coefficients.front())
                write_png(strip.all(3), report.file("bar_friction.png"));
        }
    report.table("bar_friction", moments);
    report.table("bar_friction_rest", table);
    report.page_table("bar_friction_rest", table);
    report.plot("chapters/06_redefinition/plots/bar_friction.gp");
    report.fact("bar_friction", "steps", static_cast<double>(steps));
    report.fact("bar_friction", "drift_um", 1e6 * worst, 2);
}

}  // namespace enduring::chapter06
