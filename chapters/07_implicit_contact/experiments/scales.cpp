#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter07 {
namespace {

constexpr int cubes = 4;

/// A stack of cubes of this size, laid down at rest, with gaps that rounding does not close: chapter 6 finds
/// no pair for a corner that begins inside.
Scene stack_of_size(double size, double dt)
{
    constexpr double gap = 1e-8;  // of the size
    std::vector<Box> boxes = stack_of(cubes);
    for (Box& box : boxes) {
        box.centre *= (1 + 2 * gap) * size;
        box.size *= size;
        box.mass *= size * size * size;
    }
    return scene_of(boxes, dt);
}

/// How much lower its top is than that of cubes which nothing presses [% of the height].
double lowered(const Scene& scene, double size)
{
    const double height = cubes * size, top = scene.world.bodies.back()->centre().y() + size / 2;
    return 100 * (height - top) / height;
}

struct Lowered {
    double percent, drift;  ///< the drift in sizes a second of a cube of 1 m
    long unconverged;
};

Lowered lay(double size, double dt, std::optional<double> wanted_depth, double duration)
{
    Scene scene = stack_of_size(size, dt);
    scene.contact.wanted_depth = wanted_depth;
    const PileOutcome outcome = watch(scene, duration, chapter07_solver);
    return {lowered(scene, size), 1e-6 * outcome.drift_um_per_s / std::sqrt(size),
            outcome.solves.unconverged};
}

}  // namespace

/// One stack in sizes from a millimetre to a hundred metres: with a depth that is a part of its size, and
/// with one in metres.
void scales(const RunOptions& options, Report& report)
{
    constexpr double metres = 1e-5;
    Table table({"size_m", "dt_s", "low_percent", "low_with_10_um_percent", "drift", "unconverged"});
    double worst = 0, worst_in_metres = 0;
    for (const double size : {0.001, 0.01, 0.1, 1.0, 10.0, 100.0})
        for (const bool scaled_step : {true, false}) {
            if (size == 1 && !scaled_step)
                continue;  // the same
            const double dt = scaled_step ? 0.01 * std::sqrt(size) : 0.01,
                         duration = (options.quick ? 200 : 2000) * dt;
            const Lowered part = lay(size, dt, std::nullopt, duration),
                          fixed = lay(size, dt, metres, duration);
            table.add({size, dt, part.percent, fixed.percent, part.drift, part.unconverged});
            worst = std::max(worst, part.percent);
            worst_in_metres = std::max(worst_in_metres, fixed.percent);
        }
    report.table("scales", table);
    report.page_table("scales", table, 2);
    report.fact("scales", "worst_percent", worst, 2);
    report.fact("scales", "in_metres_percent", worst_in_metres, 2);
}

}  // namespace enduring::chapter07
