#include "experiments.hpp"

#include "../category.hpp"
#include "common/render/film_probes.hpp"
#include "common/simulation/run.hpp"
#include "known_truth.hpp"
#include "label_marks.hpp"
#include "pair_census.hpp"

#include <algorithm>

namespace enduring::chapter05 {
namespace {

void slide(const std::filesystem::path& file, Report& report)
{
    Scene scene = load_scene(file);
    CensusProbe probe("cube");
    StripProbe pictures(scene, {0.05, 0.2, 0.325, 0.5}, mark_by_label);
    run(scene, chapter05_solver(scene.contact), {&probe, &pictures});
    write_png(pictures.all(2), report.file("sliding.png"));
    report.table("sliding", probe.table());
    report.plot(plot_script("sliding"), "sliding");
    report.fact("sliding_categories", "hooked_share_percent", 100 * probe.total().hooked_sideways / probe.total().sideways, 4);
    report.fact("sliding_categories", "sideways", probe.total().sideways, 3);
    report.fact("sliding_categories", "stopped_at", probe.stopped_at(), 3);
    report.fact("sliding_categories", "way", probe.way(), 3);
}

Cell share(long part, long all) { return all > 0 ? Cell(100.0 * double(part) / double(all)) : Cell(std::string("-")); }

}  // namespace

/// The scene of thesis 6.1.2 labelled, and the labels against the truth where it is known.
void sliding_categories(const RunOptions& options, Report& report)
{
    slide(options.scene.value_or(scene_file("hooked")), report);

    Table table({"scene", "true pairs", "labelled regular [%]", "artefacts", "labelled hooked [%]", "at 45°"});
    LabelCounts all;
    for (const TruthScene& scene : truth_scenes()) {
        const LabelCounts found = count_labels(scene, options.quick ? 0.5 : 1.0);
        table.add({scene.name, found.true_pairs(), share(found.true_regular, found.true_pairs()), found.artefacts(),
                   share(found.artefact_hooked, found.artefacts()), found.on_border});
        all += found;
    }
    report.table("labels", table);
    report.page_table("labels", table, 4);
    report.fact("sliding_categories", "true_found_percent", 100.0 * double(all.true_regular) / double(std::max(1L, all.true_pairs())), 4);
    report.fact("sliding_categories", "artefacts_found_percent", 100.0 * double(all.artefact_hooked) / double(std::max(1L, all.artefacts())), 4);
}

}  // namespace enduring::chapter05
