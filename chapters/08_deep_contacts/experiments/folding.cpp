#include "chapters/08_deep_contacts/experiments/bent_bars.hpp"
#include "chapters/08_deep_contacts/experiments/experiments.hpp"
#include "chapters/08_deep_contacts/experiments/self_crossings.hpp"
#include "chapters/08_deep_contacts/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/deformable_body.hpp"

#include <algorithm>

namespace enduring::chapter08 {
namespace {

/// What is varied.
struct Variant {
    double young;  ///< [Pa]
    int cells;     ///< for each 5 cm of a body's length
    double dt;     ///< [s]
    double mu;
    bool self_contact = true;
};

void add_soft(Scene& scene, const std::string& name, const TetrahedralMesh& mesh, const Variant& variant,
              const Vec3& position, const Vec3& velocity = Vec3::Zero())
{
    DeformableSettings settings;
    settings.material = {.young = variant.young, .poisson = 0.3, .density = 1000, .stiffness_damping = 0.01};
    settings.impulse_response = ImpulseResponse::implicit;
    settings.self_contact = variant.self_contact;
    settings.position = position;
    settings.velocity = velocity;
    scene.world.bodies.push_back(std::make_unique<DeformableBody>(name, mesh, settings));
}

Scene empty_scene(const Variant& variant)
{
    Scene scene;
    scene.name = "folding";
    scene.dt = variant.dt;
    scene.contact.friction = MassSplitting{.mu_s = variant.mu, .mu_d = 0.8 * variant.mu};
    scene.camera = {{0.3, 0.3, 1.0}, {0.05, 0.12, 0}, 30};
    return scene;
}

/// 60 cm of a strip of 2 cm fall on their end.
Scene falling_strip(const Variant& variant)
{
    Scene scene = empty_scene(variant);
    scene.world.planes.push_back({"ground"});
    add_soft(scene, "strip", upright_strip(0.4, 0.02, 0.03, {8 * variant.cells, 1, 1}, 0.02), variant,
             {0, 0.05, 0});
    return scene;
}

/// Two spirals fly into each other, weightless.
Scene spirals(const Variant& variant)
{
    Scene scene = empty_scene(variant);
    scene.world.gravity.setZero();
    const TetrahedralMesh mesh = spiral(0.03, 0.06, 0.5, 0.015, 0.03, {10 * variant.cells, 1, 1});
    add_soft(scene, "left", mesh, variant, {-0.14, 0, 0}, {2, 0, 0});
    add_soft(scene, "right", mesh, variant, {0.14, 0.02, 0}, {-2, 0, 0});
    return scene;
}

/// What a run showed.
struct Folded {
    long pairs = 0;                  ///< of a body with itself, the most in any step
    long crossings = 0, deeper = 0;  ///< edges through faces, the most after any step; without the skin
    long inverted = 0;               ///< elements, the most after any step
    double first = 0, most = 0;      ///< energy at first, and the most after any step [J]
    double impact = 0, rest = 0;     ///< kinetic energy, the most after any step and at the end [J]
    double impulse = 0,
           momentum = 0;  ///< mass times speed at first; the most that the sum of momenta changes [kg m/s]
    double search_share = 0;  ///< of a step's time
    long solves = 0, unconverged = 0;
    int steps = 0;
};

/// Surfaces that touch are pressed into each other. So much of it does not count, a twentieth of a body's
/// thickness [m].
constexpr double skin = 1e-3;

/// The sums over all bodies of a world.
struct Sums {
    Vec3 momentum = Vec3::Zero();
    double kinetic = 0, energy = 0, impulse = 0;
    long crossings = 0, deeper = 0, inverted = 0;
};

Sums sums_of(const World& world)
{
    Sums sums;
    for (const auto& body : world.bodies) {
        const Energy energy = body->energy(world.gravity);
        sums.kinetic += energy.kinetic;
        sums.energy += energy.total();
        sums.momentum += body->linear_momentum();
        sums.impulse += body->linear_momentum().norm();
        sums.inverted += body->inverted_elements();
        if (const RestNeighbours* neighbours = rest_neighbours(*body)) {
            sums.crossings += self_crossings(*body, *neighbours);
            sums.deeper += self_crossings(*body, *neighbours, skin);
        }
    }
    return sums;
}

long own_pairs(const Contacts& contacts)
{
    return std::count_if(contacts.begin(), contacts.end(), [](const Contact& c) {
        return c.kind != ContactKind::vertex_plane && c.body_a == c.body_b;
    });
}

Folded fold(Scene& scene, int steps, Probe* film = nullptr)
{
    Folded found;
    Sums first;
    WatchProbe watch([&](const World& world, const Contacts& contacts, double) {
        const Sums now = sums_of(world);
        if (world.step == 0)
            first = now;
        found.pairs = std::max(found.pairs, own_pairs(contacts));
        found.crossings = std::max(found.crossings, now.crossings);
        found.deeper = std::max(found.deeper, now.deeper);
        found.inverted = std::max(found.inverted, now.inverted);
        found.most = std::max(found.most, now.energy);
        found.impact = std::max(found.impact, now.kinetic);
        found.rest = now.kinetic;
        found.momentum = std::max(found.momentum, (now.momentum - first.momentum).norm());
    });
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) {
        ++found.solves;
        found.unconverged += !record.converged;
    };
    std::vector<Probe*> probes{&watch};
    if (film != nullptr)
        probes.push_back(film);
    const RunResult result = run(scene, chapter08_solver(scene.contact, settings), probes,
                                 failure_on_purpose({.steps = steps}));
    found.first = first.energy;
    found.impulse = first.impulse;
    found.steps = result.steps;
    for (const char* pass : {"broad phase", "queries", "resolve vertices", "resolve edges"})
        found.search_share += result.timings.of(pass) / result.timings.total();
    return found;
}

struct Case {
    std::string name;
    Scene (*make)(const Variant&);
    double duration;  ///< [s]
};

const std::array cases{Case{"strip", falling_strip, 2}, Case{"spirals", spirals, 0.3}};

/// All so soft that the strip folds over; a quick run takes the first.
const std::array variants{Variant{3e4, 2, 0.005, 0.3}, Variant{2e4, 2, 0.005, 0.3}, Variant{3e4, 2, 0.01, 0},
                          Variant{3e4, 3, 0.005, 0.3}, Variant{2e4, 2, 0.01, 0.8}};

/// The first variant with and without contact of the body with itself, from when it folds.
void show(const Case& shown, Report& report)
{
    std::vector<StripPicture> rows;
    for (const bool self_contact : {false, true}) {
        Variant variant = variants[0];
        variant.self_contact = self_contact;
        Scene scene = shown.make(variant);
        StripProbe film(
            scene, {0.45, 0.6, 0.65, 0.75}, [](auto&&...) {}, 400, 284);
        fold(scene, static_cast<int>(0.76 / scene.dt), &film);
        rows.push_back({film.all(4), self_contact ? "meets itself" : "does not"});
    }
    write_png(strip(rows, 1), report.file("folding.png"));
}

}  // namespace

/// Soft bodies that fold onto themselves: a strip and two spirals.
void folding(const RunOptions& options, Report& report)
{
    Table table({"body", "young_pa", "cells_per_5_cm", "dt_s", "friction", "steps", "own_pairs", "crossings",
                 "crossings_deeper", "inverted", "energy_gain_percent", "rest_percent", "search_percent",
                 "unconverged"});
    long deeper = 0, steps = 0;
    double rest = 0, momentum = 0, share = 0, gain = -1e9;
    for (const Case& c : cases)
        for (const Variant& variant : variants) {
            if (options.quick && &variant != &variants[0])
                continue;
            Scene scene = c.make(variant);
            const Folded f = fold(scene,
                                  static_cast<int>((options.quick ? 0.5 : 1) * c.duration / scene.dt + 0.5));
            const double gained = (f.most - f.first) / f.impact;
            table.add({c.name, variant.young, static_cast<long>(variant.cells), variant.dt, variant.mu,
                       static_cast<long>(f.steps), f.pairs, f.crossings, f.deeper, f.inverted, 100 * gained,
                       100 * f.rest / f.impact, 100 * f.search_share, f.unconverged});
            deeper += f.deeper;
            steps += f.steps;
            gain = std::max(gain, gained);
            share = std::max(share, f.search_share);
            if (scene.world.gravity.isZero())
                momentum = std::max(momentum, f.momentum / f.impulse);
            else
                rest = std::max(rest, f.rest / f.impact);
        }
    show(cases[0], report);
    report.table("folding", table);
    report.page_table("folding", table, 3);
    report.fact("folding", "steps", static_cast<double>(steps), 6);
    report.fact("folding", "deeper", static_cast<double>(deeper), 6);
    report.fact("folding", "gain_percent", 100 * gain);
    report.fact("folding", "rest_percent", 100 * rest);
    report.fact("folding", "momentum", momentum, 2);
    report.fact("folding", "search_percent", 100 * share, 2);
}

}  // namespace enduring::chapter08
