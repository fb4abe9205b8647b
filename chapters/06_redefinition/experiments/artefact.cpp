#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/06_redefinition/experiments/motivating_scene.hpp"
#include "common/experiments/run/run.hpp"

namespace enduring::chapter06 {
namespace {

/// Runs the scene under one solver: moments of it side by side, the number after each step, and the last as a fact.
void watch(const MotivatingScene& motivating, int chapter, Table& numbers, std::vector<StripPicture>& pictures, Report& report)
{
    Scene scene = load_scene(scene_file(motivating.file), motivating.patch);
    const std::string solver = "chapter " + std::to_string(chapter);
    Gauge gauge(motivating.reading);
    WatchProbe note([&](const World& world, const Contacts&, double) {
        if (gauge.value())
            numbers.add({static_cast<long>(chapter), world.time, *gauge.value()});
    });
    StripProbe strip(scene, motivating.moments, mark_pairs, 480, 320);
    run(scene, solver_of(chapter, scene.contact), {&gauge, &note, &strip}, limits_of(motivating, chapter));
    pictures.push_back({strip.all(0), solver});
    if (gauge.value())
        report.fact(motivating.name, "chapter_" + std::to_string(chapter), *gauge.value(), 3);
}

}  // namespace

void artefact(const std::string& name, const RunOptions&, Report& report)
{
    const MotivatingScene& scene = motivating_scene(name);
    Table numbers({"chapter", "time_s", scene.unit.empty() ? "value" : "value_" + scene.unit});
    std::vector<StripPicture> pictures;
    for (const int chapter : {5, 6})
        watch(scene, chapter, numbers, pictures, report);
    report.table(name, numbers);
    report.fact(name, "limit", scene.limit, 3);
    write_png(strip(pictures, 1), report.file(name + ".png"));
}

}  // namespace enduring::chapter06
