#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/solver.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/05_categorisation/experiments/experiments.hpp"
#include "chapters/05_categorisation/experiments/known_truth.hpp"
#include "chapters/05_categorisation/experiments/label_marks.hpp"
#include "chapters/05_categorisation/experiments/pair_census.hpp"
#include "chapters/05_categorisation/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>

namespace enduring::chapter05 {
namespace {

/// Chapter 4's solver on the same cube: on a plane and on triangles that
/// form it, without friction and with a little.
void chapter_4_defeated(const std::filesystem::path& file, Report& report)
{
    const std::string plane =
        R"({"planes": [{"name": "floor"}], "bodies": [{"name": "cube", "type": "rigid", "mass": 20,
        "shape": {"box": {"size": [0.5, 0.5, 0.5]}}, "position": [0, 0.255, 0.03], "velocity": [1.5, 0, 0]}])";
    const std::string rough =
        R"("contact": {"friction": {"model": "mass_splitting", "mu_s": 0.1, "mu_d": 0.05}})";
    Table table({"floor", "mu_d", "distance_m", "speed after 1.5 s [m/s]"});
    for (const bool triangles : {false, true})
        for (const bool friction : {false, true}) {
            const std::string patch = triangles ? (friction ? "{" + rough + "}" : "")
                                                : plane + (friction ? ", " + rough : "") + "}";
            Scene scene = load_scene(file, patch);
            CensusProbe probe("cube");
            run(scene, chapter04_solver(scene.contact), {&probe});
            table.add({std::string(triangles ? "triangles" : "plane"), friction ? 0.05 : 0.0, probe.way(),
                       probe.last_speed()});
        }
    report.table("defeat", table);
    report.page_table("defeat", table);
}

void slide(const std::filesystem::path& file, Report& report)
{
    Scene scene = load_scene(file);
    CensusProbe probe("cube");
    StripProbe pictures(scene, {0.05, 0.2, 0.325, 0.5}, mark_by_label);
    run(scene, chapter05_solver(scene.contact), {&probe, &pictures});
    write_png(pictures.all(2), report.file("sliding.png"));
    report.table("sliding", probe.table());
    report.plot("chapters/05_categorisation/plots/sliding.gp");
    report.fact("sliding_categories", "hooked_share_percent",
                100 * probe.total().hooked_sideways / probe.total().sideways, 4);
    report.fact("sliding_categories", "sideways", probe.total().sideways, 3);
    report.fact("sliding_categories", "stopped_at", probe.stopped_at(), 3);
    report.fact("sliding_categories", "way", probe.way(), 3);
}

Cell share(long part, long all)
{
    return all > 0 ? Cell(100.0 * double(part) / double(all)) : Cell(std::string("-"));
}

}  // namespace

/// The scene of thesis 6.1.2 labelled, and the labels against the truth where it is known.
void sliding_categories(const RunOptions& options, Report& report)
{
    chapter_4_defeated(options.scene.value_or(scene_file("hooked")), report);
    slide(options.scene.value_or(scene_file("hooked")), report);

    Table table(
        {"scene", "true pairs", "labelled regular [%]", "artefacts", "labelled hooked [%]", "at 45°"});
    LabelCounts all;
    for (const TruthScene& scene : truth_scenes()) {
        const LabelCounts found = count_labels(scene, options.quick ? 0.5 : 1.0);
        table.add({scene.name, found.true_pairs(), share(found.true_regular, found.true_pairs()),
                   found.artefacts(), share(found.artefact_hooked, found.artefacts()), found.on_border});
        all += found;
    }
    report.table("labels", table);
    report.page_table("labels", table, 4);
    report.fact("sliding_categories", "true_found_percent",
                100.0 * double(all.true_regular) / double(std::max(1L, all.true_pairs())), 4);
    report.fact("sliding_categories", "artefacts_found_percent",
                100.0 * double(all.artefact_hooked) / double(std::max(1L, all.artefacts())), 4);
}

}  // namespace enduring::chapter05
