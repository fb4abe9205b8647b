#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/solver.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace enduring::chapter11 {
namespace {

/// How much lower the top of a stack of cubes of 1 m is than without a load [m].
double lowered(const Scene& scene)
{
    const auto cubes = static_cast<double>(scene.world.bodies.size());
    return cubes - (scene.world.bodies.back()->centre().y() + 0.5);
}

struct Rest {
    double lowered_m, drift_um_per_s;
    long unconverged = 0;
};

/// Where a stack is at the end, and how fast its top has moved in the second half of the time.
Rest at_rest(const std::vector<chapter07::Box>& boxes, double duration, double h, chapter07::MakeSolver make)
{
    Scene scene = chapter07::scene_of(boxes, 0.01);
    scene.contact.wanted_depth = 1;  // [m]: no load asks for a stiffer spring
    long unconverged = 0;
    ImplicitSettings settings;
    settings.stiffness.k_dt2_over_m = h / distance_parts.stiffer;
    settings.record = [&](const SolveRecord& record) { unconverged += !record.converged; };
    const Solver solver = make(scene.contact, settings);
    Contacts contacts;
    const long steps = std::lround(duration / scene.dt);
    Vec3 at_half_time = Vec3::Zero();
    for (long step = 0; step < steps; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        if (step == steps / 2)
            at_half_time = scene.world.bodies.back()->centre();
    }
    const double moved = (scene.world.bodies.back()->centre() - at_half_time).norm();
    return {lowered(scene), 1e6 * moved / (0.5 * duration), unconverged};
}

/// Where the passes of soft springs end is seen in the table.
Solver silent_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    return chapter11_solver(parameters, std::move(settings), {.record = [](const PassRecord&) {}});
}

}  // namespace

/// Stacks of cubes at rest, on springs that are pressed and on springs that remember, over their stiffness.
void stack_exact(const RunOptions& options, Report& report)
{
    const double duration = options.quick ? 2 : 10;
    Table table({"stack", "h", "chapter_10_lowered_m", "lowered_m", "drift_um_per_s", "unconverged"});
    for (const double h : {10.0, 100.0, 1000.0})
        for (const bool heavy : {false, true}) {
            const auto boxes = heavy ? chapter07::stack_of(2, 10, 1000) : chapter07::stack_of(10);
            const Rest before = at_rest(boxes, duration, h, chapter10_solver),
                       now = at_rest(boxes, duration, h, silent_solver);
            table.add({heavy ? "1000 kg on 10 kg" : "10 cubes", h, before.lowered_m, now.lowered_m,
                       now.drift_um_per_s, now.unconverged});
            if (!heavy && h == 100)
                report.fact("stack_exact", "before_m", before.lowered_m, 2);
        }
    report.table("stack_exact", table);
    report.page_table("stack_exact", table, 2);
}

}  // namespace enduring::chapter11
