#include "chapters/08_deep_contacts/experiments/bent_bars.hpp"
#include "chapters/08_deep_contacts/experiments/experiments.hpp"
#include "chapters/08_deep_contacts/experiments/soft_runs.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/report/progress.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/read_gmsh.hpp"
#include "common/input/source_directory.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>

namespace enduring::chapter08 {
namespace {

/// 40 cm of a strip of 2 cm fall on their end.
SoftRun falling_strip(const SoftVariant& variant)
{
    SoftRun run = soft_run(variant);
    run.scene.world.planes.push_back({"ground"});
    add_soft(run.scene, "strip", upright_strip(0.4, 0.02, 0.03, {8 * variant.cells, 1, 1}, 0.02), variant,
             {0, 0.05, 0});
    return run;
}

/// Two spirals fly into each other, weightless.
SoftRun spirals(const SoftVariant& variant)
{
    SoftRun run = soft_run(variant);
    run.scene.world.gravity.setZero();
    const TetrahedralMesh mesh = spiral(0.03, 0.06, 0.5, 0.015, 0.03, {10 * variant.cells, 1, 1});
    add_soft(run.scene, "left", mesh, variant, {-0.14, 0, 0}, {2, 0, 0});
    add_soft(run.scene, "right", mesh, variant, {0.14, 0.02, 0}, {-2, 0, 0});
    return run;
}

/// A board falls on a ring that stands on the ground.
SoftRun squashed_ring(const SoftVariant& variant)
{
    SoftRun run = soft_run(variant);
    run.scene.world.planes.push_back({"ground"});
    add_soft(run.scene, "ring", ring(0.06, 0.012, 0.03, {8 * variant.cells, 1, 1}), variant, {0, 0.067, 0});
    SurfaceMesh board = box({0.3, 0.02, 0.1}, {6, 1, 2});
    for (Vec3& x : board.vertices)
        x.y() += 0.15;
    run.scene.world.bodies.push_back(std::make_unique<RigidBody>(
        "board", board, with_mass(mass_properties(board, 1000), 0.5), Vec3(0, -1, 0)));
    run.scene.camera = {{0.12, 0.08, 0.7}, {0, 0.06, 0}, 24};
    return run;
}

/// A bunny's ears are pulled down to its back and let go. It is weightless, and its feet are held.
SoftRun pressed_ears(const SoftVariant& variant)
{
    constexpr double scale = 0.02;  // of the scan, in which it is 9 m high
    SoftRun run = soft_run(variant);
    run.scene.world.gravity.setZero();
    TetrahedralMesh mesh = read_gmsh(source_directory() / "common/meshes" /
                                     (variant.cells > 2 ? "bunny_785.msh" : "bunny_363.msh"));
    std::vector<int> feet;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
        mesh.nodes[node] *= scale;
        if (mesh.nodes[node].y() < scale)
            feet.push_back(static_cast<int>(node));
    }
    add_soft(run.scene, "bunny", mesh, variant, Vec3::Zero(), Vec3::Zero(), feet);
    const Body& bunny = *run.scene.world.bodies.back();
    Pull ears{.force = {1, -2, 0.2}, .until = 1};
    for (int vertex = 0; vertex < bunny.surface().vertex_count(); ++vertex)
        if (bunny.positions_t0()[vertex].y() > 7.6 * scale)
            ears.vertices.push_back(vertex);
    run.pulls = {ears};
    run.scene.camera = {{0.1, 0.2, 0.7}, {0, 0.088, 0}, 18};
    return run;
}

struct Case {
    std::string name;
    SoftRun (*make)(const SoftVariant&);
    double duration;            ///< [s]
    std::string picture;        ///< its file, empty for none
    std::vector<double> shown;  ///< in it [s]
};

const std::vector<Case>& cases()
{
    static const std::vector<Case> all{{"strip", falling_strip, 2, "folding.png", {0.45, 0.6, 0.65, 0.75}},
                                       {"spirals", spirals, 0.3, "", {}},
                                       {"ring", squashed_ring, 1, "folding_ring.png", {0.05, 0.09, 0.2, 0.5}},
                                       {"ears", pressed_ears, 2, "folding_ears.png", {0.05, 0.2, 1, 1.5}}};
    return all;
}

constexpr int long_run = 20000;  ///< steps

/// All so soft that the strip folds over; a quick run takes the first.
const std::array variants{SoftVariant{3e4, 2, 0.005, 0.3}, SoftVariant{2e4, 2, 0.005, 0.3},
                          SoftVariant{3e4, 2, 0.01, 0}, SoftVariant{3e4, 3, 0.005, 0.3},
                          SoftVariant{2e4, 2, 0.01, 0.8}};

/// A case with and without contact of the body with itself.
void show_folds(const Case& shown, Report& report)
{
    std::vector<StripPicture> rows;
    for (const bool self_contact : {false, true}) {
        SoftVariant variant = variants[0];
        variant.self_contact = self_contact;
        SoftRun run = shown.make(variant);
        StripProbe film(
            run.scene, shown.shown, [](auto&&...) {}, 400, 284);
        fold(run, static_cast<int>(shown.shown.back() / run.scene.dt) + 2, {&film});
        const std::string caption = self_contact ? "with" : "without";
        rows.push_back({film.all(4), caption + " self-contact"});
    }
    write_png(strip(rows, 1), report.file(shown.picture));
}

/// What all runs showed, row by row and the worst of them.
struct CollectedFolds {
    Table found{{"body", "young_pa", "cells_per_5_cm", "dt_s", "friction", "steps", "own_pairs", "crossings",
                 "deepest_um", "crossings_at_end", "deepest_at_end_um", "inverted", "energy_gain_percent",
                 "rest_percent"}};
    Table cost{{"body", "young_pa", "cells_per_5_cm", "dt_s", "friction", "search_percent", "answers_percent",
                "solves", "unconverged"}};
    long steps = 0, inverted = 0;
    double depth = 0, depth_at_end = 0, rest = 0, momentum = 0, share = 0, gain = -1e9;

    void add(const std::string& name, const SoftVariant& variant, const SoftRun& run, const Folded& f)
    {
        const double gained = (f.most - f.first) / f.impact;
        const long cells = variant.cells;
        found.add({name, variant.young, cells, variant.dt, variant.mu, static_cast<long>(f.steps), f.pairs,
                   f.crossings, 1e6 * f.depth, f.crossings_at_end, 1e6 * f.depth_at_end, f.inverted,
                   100 * gained, 100 * f.rest / f.impact});
        cost.add({name, variant.young, cells, variant.dt, variant.mu, 100 * f.search_share,
                  100 * f.answer_share, f.solves, f.unconverged});
        steps += f.steps;
        inverted = std::max(inverted, f.inverted);
        depth = std::max(depth, f.depth);
        depth_at_end = std::max(depth_at_end, f.depth_at_end);
        gain = std::max(gain, gained);
        share = std::max(share, f.search_share + f.answer_share);
        const bool falls = !run.scene.world.gravity.isZero();
        if (falls && variant.mu > 0)  // nothing stops what slides without friction
            rest = std::max(rest, f.rest / f.impact);
        else if (!falls && run.pulls.empty())  // nothing holds it
            momentum = std::max(momentum, f.momentum / f.impulse);
    }
};

}  // namespace

/// Soft bodies that fold onto themselves.
void folding(const RunOptions& options, Report& report)
{
    CollectedFolds all;
    const std::size_t long_runs = 3, of_a_case = options.quick ? 1 : variants.size();
    Progress progress("", static_cast<long>(cases().size() * of_a_case + long_runs), " runs");
    const auto count_runs = [&] { progress.update(static_cast<long>(all.found.rows().size())); };
    for (const Case& c : cases())
        for (const SoftVariant& variant : variants) {
            if (options.quick && &variant != &variants[0])
                continue;
            SoftRun run = c.make(variant);
            const double part = options.quick ? 0.5 : 1;
            all.add(c.name, variant, run, fold(run, static_cast<int>(part * c.duration / variant.dt + 0.5)));
            count_runs();
        }
    for (const auto& [c, variant] : {std::pair(cases()[0], variants[0]), std::pair(cases()[0], variants[3]),
                                     std::pair(cases()[1], variants[0])}) {
        SoftRun run = c.make(variant);
        all.add(c.name, variant, run, fold(run, options.quick ? 20 : long_run));
        count_runs();
    }
    for (const Case& c : cases())
        if (!c.picture.empty())
            show_folds(c, report);
    report.table("folding", all.found);
    report.page_table("folding", all.found, 3);
    report.page_table("folding_cost", all.cost, 3);
    report.fact("folding", "steps", static_cast<double>(all.steps), 6);
    report.fact("folding", "deepest_mm", 1000 * all.depth, 2);
    report.fact("folding", "deepest_at_end_um", 1e6 * all.depth_at_end, 2);
    constexpr double rounding = 1e-12;  // of an energy that is a sum over the elements
    report.fact("folding", "gain_percent", all.gain < rounding ? 0 : 100 * all.gain);
    report.fact("folding", "rest_percent", 100 * all.rest);
    report.fact("folding", "momentum", all.momentum, 2);
    report.fact("folding", "share_percent_by_clock", 100 * all.share, 2);
}

}  // namespace enduring::chapter08
