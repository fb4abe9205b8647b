// Each elementary case as a strip of three pictures - before, at the
// touch, after - and what the queries say about it.
#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/experiments/experiments.hpp"
#include "chapters/02_collision_detection/experiments/gallery_cases.hpp"
#include "chapters/02_collision_detection/experiments/gallery_stage.hpp"
#include "chapters/02_collision_detection/textbook.hpp"
#include "common/input/number_text.hpp"

namespace enduring::chapter02 {
namespace {

std::string time_text(const std::optional<double>& tau) { return tau ? readable(*tau, 6) : "none"; }

void add_case(const GalleryCase& one, GalleryStage& stage, Table& table, Report& report)
{
    const auto certified = std::visit([](const auto& step) { return time_of_impact(step); }, one.step);
    const auto textbook = std::visit([](const auto& step) { return textbook_time_of_impact(step); },
                                     one.step);
    table.add({one.name, time_text(textbook), time_text(certified)});
    write_png(stage.draw_case(one, certified), report.file("gallery_" + one.name + ".png"));
}

}  // namespace

void gallery(const RunOptions&, Report& report)
{
    GalleryStage stage;
    Table table({"case", "textbook_tau", "certified_tau"});
    for (const GalleryCase& one : gallery_cases())
        add_case(one, stage, table, report);
    report.table("gallery", table);
    report.page_table("gallery", table);

    const Tunnelling scene = tunnelling();
    const auto touch = first_touch(scene);
    const int before = discrete_hits(scene.spike_t0, scene.plate),
              after = discrete_hits(scene.spike_t1, scene.plate);
    report.fact("gallery", "tunnelling_discrete_before", before);
    report.fact("gallery", "tunnelling_discrete_after", after);
    report.fact("gallery", "tunnelling_tau", touch.value_or(-1), 4);
    write_png(stage.draw_tunnelling(scene, touch.value_or(0.5)), report.file("gallery_tunnelling.png"));
    write_png(stage.draw_edge_triangle(), report.file("gallery_edge_triangle.png"));
}

}  // namespace enduring::chapter02
