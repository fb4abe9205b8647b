#include "chapters/05_categorisation/category.hpp"
#include "chapters/05_categorisation/solver.hpp"
#include "chapters/06_redefinition/experiments/bar_slide.hpp"
#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/06_redefinition/experiments/plane_slide.hpp"
#include "chapters/06_redefinition/experiments/slide_without.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/elements_of.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter06 {
namespace {

//! [plane]
/// Every direction, every triangulation, on the lines of the grid and between them.
void over_planes(bool quick, Report& report)
{
    Table table({"diagonals", "direction_deg", "on_lattice", "speed_change_percent", "sideways_percent",
                 "pairs", "sag_m"});
    double worst = 0, sideways = 0, sag = 0;
    for (const GridDiagonals diagonals : all_diagonals)
        for (int direction = quick ? 1 : 0; direction < 8; direction += quick ? 8 : 1)
            for (const bool on_lattice : {false, true}) {
                const PlaneSlide slide{diagonals, direction, on_lattice};
                if (quick && on_lattice)
                    continue;
                const SlideOutcome outcome = slide_over_plane(slide,
                                                              chapter06_solver(scene_of(slide).contact));
                table.add({name_of(diagonals), static_cast<long>(45 * direction), on_lattice ? "yes" : "no",
                           100 * outcome.speed_change, 100 * outcome.sideways_speed, outcome.mean_pairs,
                           outcome.sag});
                worst = std::max(worst, std::abs(outcome.speed_change));
                sideways = std::max(sideways, outcome.sideways_speed);
                sag = std::max(sag, outcome.sag);
            }
    report.table("sliding_plane", table);
    report.page_table("sliding_plane", table);
    report.fact("sliding", "plane_worst_percent", 100 * worst, 2);
    report.fact("sliding", "plane_sideways_percent", 100 * sideways, 2);
    report.fact("sliding", "plane_sag_um", 1e6 * sag, 2);
}
//! [plane]

/// The stiffness of one pair, and how the n k of all compares with the step.
void over_stiffness(bool quick, Report& report)
{
    Table table({"stiffness_n_per_m", "pairs", "nk_n_per_m", "stable_step_s", "dt_s", "sag_m", "rise_m",
                 "speed_change_percent"});
    std::vector<double> all{3e3, 1e4, 3e4, 1e5, 3e5, 1e6, 3e6};
    if (quick)
        all = {3e6};
    for (const double stiffness : all) {
        PlaneSlide slide;
        slide.direction = 1;
        slide.stiffness = stiffness;
        slide.may_gain_energy = true;  // the stiffest makes the cube hop
        const Scene scene = scene_of(slide);
        const SlideOutcome outcome = slide_over_plane(slide, chapter06_solver(scene.contact));
        const double nk = outcome.mean_pairs * stiffness;
        table.add({stiffness, outcome.mean_pairs, nk,
                   std::sqrt(2 * body_named(scene.world, "cube").mass() / nk), slide.dt, outcome.sag,
                   outcome.highest - outcome.lowest, 100 * outcome.speed_change});
    }
    report.table("sliding_stiffness", table);
    report.page_table("sliding_stiffness", table);
}

/// What each rule is worth: the same slide with one of them left out.
void with_omissions(bool quick, Report& report)
{
    Table table({"left_out", "pairs", "speed_change_percent", "sideways_percent", "rise_m"});
    for (const Omission omission : all_omissions) {
        if (quick && omission != Omission::edges_behind_exits)
            continue;
        PlaneSlide slide;
        slide.direction = quick ? 0 : 1;
        const SlideOutcome outcome = slide_over_plane(slide,
                                                      solver_without(omission, scene_of(slide).contact));
        table.add({name_of(omission), outcome.mean_pairs, 100 * outcome.speed_change,
                   100 * outcome.sideways_speed, outcome.highest - outcome.lowest});
    }
    report.table("sliding_rules", table);
    report.page_table("sliding_rules", table);
}

constexpr double settled = 0.3;        // [s], by then the landing is over
constexpr double front_at_end = 1.25;  // [m], x of the cube's middle when its front reaches the bar's end

/// The slide that the pictures show, with a solver of this chapter or the one before.
BarSlideOutcome along_bar(const std::filesystem::path& file, const std::string& name,
                          const RunOptions& options, Report& report, Table& moments)
{
    Scene scene = load_scene(file);
    const bool redefined = name == "chapter 6";
    const std::vector<double> times = redefined ? std::vector<double>{0.2, 1.0, 2.0, 2.4}
                                                : std::vector<double>{0.03, 0.1, 0.3, 0.6};
    if (redefined)  // the cube leaves the bar, and the picture of the other one's start
        scene.camera = {{1.55, 1.5, 3.9}, {0.45, -0.15, 0}, 36};
    BarSlideProbe probe(name);
    StripProbe vertices(scene, times, mark_vertex_pairs), edges(scene, times, mark_edge_pairs);
    RunLimits limits;
    if (options.quick)
        limits.steps = 310;
    run(scene, redefined ? chapter06_solver(scene.contact) : chapter05_solver(scene.contact),
        {&probe, &vertices, &edges}, limits);
    write_png(vertices.all(2),
              report.file(redefined ? "sliding_vertices.png" : "sliding_vertices_without.png"));
    write_png(edges.all(2), report.file(redefined ? "sliding_edges.png" : "sliding_edges_without.png"));
    moments.append(probe.table());
    return outcome_of(probe, settled, front_at_end);
}

/// A row of the table of bars.
void add_bar(Table& table, const std::string& bar, const std::string& elements, const std::string& solver,
             const BarSlideOutcome& outcome)
{
    table.add({bar, elements, solver, 100 * outcome.speed_kept, 100 * outcome.largest_leap,
               100 * outcome.mean_leap});
}

/// The same slide on a bar whose dent differs, up to where the front reaches the end.
void along_control(const std::filesystem::path& file, const std::string& bar, const std::string& change,
                   Table& table)
{
    Scene scene = load_scene(file, change);
    BarSlideProbe probe("control");
    RunLimits limits;
    limits.stop = [&](const World&, const Contacts&) { return probe.moments().back().x > front_at_end; };
    run(scene, chapter06_solver(scene.contact), {&probe}, limits);
    add_bar(table, bar, elements_of(scene.world, "bar"), "chapter 6",
            outcome_of(probe, settled, front_at_end));
}

void along_bars(const RunOptions& options, Report& report)
{
    const std::filesystem::path file = options.scene.value_or(scene_file("sliding"));
    Table moments({"solver", "time_s", "x_m", "speed_m_per_s", "force_n", "pairs", "held"});
    Table table(
        {"bar", "elements", "solver", "speed_kept_percent", "largest_leap_percent", "mean_leap_percent"});
    const std::string elements = elements_of(load_scene(file).world, "bar");
    report.fact("sliding", "elements", elements);
    const BarSlideOutcome with = along_bar(file, "chapter 6", options, report, moments),
                          without = along_bar(file, "chapter 5", options, report, moments);
    add_bar(table, "as it is", elements, "chapter 6", with);
    add_bar(table, "as it is", elements, "chapter 5", without);
    if (!options.quick) {
        along_control(file, "10 x stiffer", R"({"/bodies/bar/young": 1e6})", table);
        along_control(file, "2 x softer", R"({"/bodies/bar/young": 5e4})", table);
        along_control(file, "2 x finer", R"({"/bodies/bar/shape/bar/cells": [24, 2, 6]})", table);
        along_control(file, "linear", R"({"/bodies/bar/basis": "linear"})", table);
        along_control(file, "linear, 2 x finer",
                      R"({"/bodies/bar": {"basis": "linear", "shape": {"bar": {"cells": [24, 2, 6]}}}})",
                      table);
    }
    report.table("sliding_bar", moments);
    report.table("sliding_bars", table);
    report.page_table("sliding_bars", table);
    report.plot("chapters/06_redefinition/plots/sliding_bar.gp");
    report.fact("sliding", "bar_speed_kept_percent", 100 * with.speed_kept, 4);
    report.fact("sliding", "bar_stopped_at", without.stopped_at, 2);
    report.fact("sliding", "largest_leap_percent", 100 * with.largest_leap, 2);
    report.fact("sliding", "mean_leap_percent", 100 * with.mean_leap, 2);
    report.fact("sliding", "leaps_above_percent", 100 * with.leaps_above_percent, 2);
    report.fact("sliding", "tilt_deg", with.largest_tilt * 180 / std::numbers::pi, 2);
}

}  // namespace

void sliding(const RunOptions& options, Report& report)
{
    over_planes(options.quick, report);
    over_stiffness(options.quick, report);
    with_omissions(options.quick, report);
    along_bars(options, report);
}

}  // namespace enduring::chapter06
