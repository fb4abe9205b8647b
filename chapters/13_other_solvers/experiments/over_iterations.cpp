#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/13_other_solvers/experiments/experiments.hpp"
#include "chapters/13_other_solvers/solver.hpp"
#include "common/experiments/run/processor_clock.hpp"

#include <cmath>
#include <string>

namespace enduring::chapter13 {
namespace {

/// After a run: how far the last body is from where a rigid one would rest.
struct Left {
    double error = 0;  ///< [m]
    double ms = 0;     ///< processor time of a step
};

Left left_of(Scene scene, const Solver& solver, double seconds)
{
    const std::vector<Vec3> from = chapter07::centres_of(scene.world);
    Contacts contacts;
    const int steps = static_cast<int>(std::lround(seconds / scene.dt));
    const double start = processor_seconds();
    for (int step = 0; step < steps; ++step)
        advance(scene.world, contacts, solver, scene.dt);
    return {chapter07::longest_displacement(scene.world, from), 1000 * (processor_seconds() - start) / steps};
}

}  // namespace

/// A stack of ten and a cube on a slope, after a second: how far something has moved that should have rested.
void over_iterations(const RunOptions& options, Report& report)
{
    const double seconds = options.quick ? 0.3 : 1;
    const std::vector<int> counts = options.quick ? std::vector{1, 4, 16}
                                                  : std::vector{1, 2, 4, 8, 16, 32, 64, 128, 256};
    Table table({"method", "n", "stack_m", "slope_m", "step_ms_by_clock"});
    for (const OtherMethod& method : other_methods())
        for (const int n : counts) {
            Scene stack = chapter07::scene_of(chapter07::stack_of(10), 0.01),
                  slope = chapter07::scene_of({{10, Vec3(0, 0.5, 0), 0}}, 0.01, 20);
            const Solver of_stack = method.make_with(stack.contact, n),
                         of_slope = method.make_with(slope.contact, n);
            const Left in_stack = left_of(std::move(stack), of_stack, seconds),
                       on_slope = left_of(std::move(slope), of_slope, seconds);
            table.add({method.title, static_cast<long>(n), in_stack.error, on_slope.error, in_stack.ms});
            if (n == 1 || n == 16)
                report.fact("over_iterations", method.name + "_stack_mm_" + std::to_string(n),
                            1e3 * in_stack.error, 2);
            if (n == 16)
                report.fact("over_iterations", method.name + "_slope_mm_16", 1e3 * on_slope.error, 2);
        }
    report.table("over_iterations", table);
    report.plot("chapters/13_other_solvers/plots/over_iterations.gp");
}

}  // namespace enduring::chapter13
