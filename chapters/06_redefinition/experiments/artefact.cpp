#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/motivating_scenes/motivating_scene.hpp"
#include "common/experiments/run/run.hpp"

namespace enduring::chapter06 {
namespace {

using namespace motivating;

/// Runs the scene under one solver: moments of it side by side, the
/// number after each step, and the last as a fact.
void watch(const MotivatingScene& motivating, const Compared& compared, Table& numbers,
           std::vector<StripPicture>& pictures, Report& report)
{
    Scene scene = load_scene(scene_file(motivating.file), motivating.patch);
    const std::string solver = "chapter " + std::to_string(compared.chapter);
    Gauge gauge(motivating.reading);
    WatchProbe note([&](const World& world, const Contacts&, double) {
        if (gauge.value())
            numbers.add({static_cast<long>(compared.chapter), world.time, *gauge.value()});
    });
    StripProbe strip(scene, motivating.moments, mark_pairs, 480, 320);
    run(scene, compared.make(scene.contact), {&gauge, &note, &strip},
        limits_of(motivating, compared.chapter));
    pictures.push_back({strip.all(0), solver});
    if (gauge.value())
        report.fact(motivating.name, "chapter_" + std::to_string(compared.chapter), *gauge.value(), 3);
}

}  // namespace

void artefact(const std::string& name, const RunOptions&, Report& report)
{
    const MotivatingScene& scene = motivating_scene(name);
    Table numbers({"chapter", "time_s", scene.unit.empty() ? "value" : "value_" + scene.unit});
    std::vector<StripPicture> pictures;
    for (const Compared& compared : last_and_this)
        watch(scene, compared, numbers, pictures, report);
    report.table(name, numbers);
    report.fact(name, "limit", scene.limit, 3);
    write_png(strip(pictures, 1), report.file(name + ".png"));
}

}  // namespace enduring::chapter06
