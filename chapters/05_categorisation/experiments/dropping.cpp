#include "chapters/05_categorisation/experiments/experiments.hpp"
#include "chapters/05_categorisation/experiments/intrusion.hpp"
#include "common/experiments/render/strip.hpp"

namespace enduring::chapter05 {

/// What the thesis does not do, and why: remove the pairs that are labelled hooked.
void dropping(const RunOptions&, Report& report)
{
    Table table(
        {"scene", "hooked pairs", "deepest_mm", "vertices inside without a pair", "speed at the end [m/s]"});
    Table depths({"hooked_pairs", "time_s", "depth_m"});
    std::vector<StripPicture> pictures;
    for (const IntrusionScene& scene : intrusion_scenes()) {
        const bool wall = scene.obstacle == "wall";
        for (const HookedPairs treatment : {HookedPairs::pushed, HookedPairs::dropped}) {
            const Intrusion found = intrude(scene, treatment);
            const std::string word = treatment == HookedPairs::pushed ? "pushed" : "dropped";
            table.add({scene.name, word, 1000 * found.deepest, found.lost_vertices, found.last_speed});
            report.fact("dropping", scene.body + "_" + word + "_mm", 1000 * found.deepest, 3);
            report.fact("dropping", scene.body + "_" + word + "_lost", double(found.lost_vertices), 3);
            if (!wall)
                continue;
            for (const std::vector<Cell>& row : found.depths.rows())
                depths.add(row);
            pictures.push_back(
                {picture_of_intrusion(scene, treatment, found.deepest_at), "hooked pairs " + word});
        }
    }
    report.fact("dropping", "wall_mm", 1000 * intrusion_scenes().back().thickness, 3);
    report.table("dropping", table);
    report.page_table("dropping", table);
    report.table("wall", depths);
    report.plot("chapters/05_categorisation/plots/wall.gp");
    write_png(strip(pictures), report.file("dropping.png"));
}

}  // namespace enduring::chapter05
