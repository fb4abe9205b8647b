#include "chapters/10_self_contact/experiments/experiments.hpp"
#include "chapters/10_self_contact/experiments/folding_scenes.hpp"
#include "chapters/10_self_contact/experiments/self_crossings.hpp"
#include "common/experiments/render/moments.hpp"
#include "common/experiments/report/progress.hpp"

#include <algorithm>

namespace enduring::chapter10 {
namespace {

struct Case {
    std::string name;
    SoftRun (*make)(const SoftVariant&);
    double duration;            ///< [s]
    std::string picture;        ///< its file, empty for none
    std::vector<double> shown;  ///< in it [s]
    Vec3 seen_from;             ///< direction to the camera
    double young_shown = 3e4;   ///< [Pa]
};

const std::vector<Case>& cases()
{
    static const std::vector<Case> all{
        {"strip", falling_strip, 2, "folding.png", {0.6, 0.65, 0.75}, {0.3, 0.25, 1}},
        {"spirals", spirals, 0.3, "", {}, Vec3::UnitZ()},
        {"ring", squashed_ring, 1, "folding_ring.png", {0.08, 0.15, 0.2}, {0.25, 0.2, 1}, 1e4},
        {"ears", pressed_ears, 2, "folding_ears.png", {0.05, 1, 1.5}, {0.15, 0.2, 1}}};
    return all;
}

constexpr int long_run = 20000;  ///< steps

/// All so soft that the strip folds over; a quick run takes the first.
const std::array variants{SoftVariant{3e4, 2, 0.005, 0.3}, SoftVariant{2e4, 2, 0.005, 0.3},
                          SoftVariant{3e4, 2, 0.01, 0}, SoftVariant{3e4, 3, 0.005, 0.3},
                          SoftVariant{2e4, 2, 0.01, 0.8}};

/// Rigid bodies pale, and a dot where an edge passes through a face of its own body.
/// @param twin  of the same bodies, which look for contact with themselves: it knows who are neighbours
MarkContacts mark_self_crossings(const World& twin)
{
    return [&twin](Stage& stage, const World& world, const Contacts&) {
        for (std::size_t i = 0; i < world.bodies.size(); ++i) {
            const RestNeighbours* neighbours = rest_neighbours(*twin.bodies[i]);
            if (neighbours == nullptr) {
                stage.bodies[i].opacity = 0.3;
                continue;
            }
            for (const Vec3& point : self_crossing_points(*world.bodies[i], *neighbours))
                stage.dots.push_back({point, palette::colliding_vertex, 4});
        }
    };
}

/// Edges of all bodies that pass through faces of their own body.
/// @param twin  see mark_self_crossings()
long own_crossings(const World& world, const World& twin)
{
    long count = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
        if (const RestNeighbours* neighbours = rest_neighbours(*twin.bodies[i]))
            count += self_crossings(*world.bodies[i], *neighbours);
    return count;
}

/// A case without and with contact of the body with itself.
void show_folds(const Case& shown, Report& report)
{
    std::vector<Moment> moments;
    SoftVariant variant = variants[0];
    variant.young = shown.young_shown;
    const SoftRun twin = shown.make(variant);
    for (const bool self_contact : {false, true}) {
        variant.self_contact = self_contact;
        SoftRun run = shown.make(variant);
        MomentsProbe film(run.scene, shown.shown, mark_self_crossings(twin.scene.world),
                          self_contact ? "with, " : "without, ");
        fold(run, static_cast<int>(shown.shown.back() / run.scene.dt) + 2, {&film});
        if (shown.name == "strip")
            report.fact("folding", self_contact ? "shown_with" : "shown_without",
                        static_cast<double>(own_crossings(run.scene.world, twin.scene.world)), 4);
        moments.insert(moments.end(), film.moments().begin(), film.moments().end());
    }
    constexpr int width = 480, height = 270;
    frame_together(moments, shown.seen_from, static_cast<double>(width) / height);
    write_png(draw_moments(moments, static_cast<int>(shown.shown.size()), width, height),
              report.file(shown.picture));
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

/// Hairpins whose ends nearly touch: nothing touches, so nothing may push.
void falling_hairpins(bool quick, Report& report)
{
    Table table({"gap_mm", "dt_ms", "pushed", "off_free_fall"});
    double pushed = 0, off = 0;
    const std::vector<double> lengths = quick ? std::vector{0.01} : std::vector{0.001, 0.01, 0.04};
    for (const double gap : {2e-3, 4e-4, 1e-4, 1e-5})
        for (const double dt : lengths) {
            const HairpinFall fall = run_hairpin(gap, dt, 20);
            table.add({1e3 * gap, 1e3 * dt, fall.pushed, fall.off_fall});
            pushed = std::max(pushed, fall.pushed);
            off = std::max(off, fall.off_fall);
        }
    report.table("folding_gaps", table);
    report.page_table("folding_gaps", table, 2);
    report.fact("folding", "gap_pushed", pushed, 1);
    report.fact("folding", "gap_off_fall", off, 1);
}

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
    falling_hairpins(options.quick, report);
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

}  // namespace enduring::chapter10
