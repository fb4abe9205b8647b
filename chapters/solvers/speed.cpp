#include "chapters/06_redefinition/solver.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/engines/bullet/bullet_solver.hpp"
#include "chapters/solvers/experiments.hpp"
#include "common/experiments/report/statistics.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/deformable_body.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enduring::solvers {
namespace {

using chapter07::Box, chapter07::loose_cubes, chapter07::scene_of, chapter07::stack_of,
    chapter07::many_stacks, chapter07::SolveStatistics;

/// What is measured is processor time, and Bullet has one thread, too.
constexpr int threads = 1;

/// Processor time of a step [ms].
struct StepTimes {
    double falling = 0;  ///< mean
    double at_rest = 0;  ///< the least of the means of twenty steps: other work on the machine counts less
};

double time_steps(Scene& scene, Contacts& contacts, const Solver& solver, int steps)
{
    const double start = processor_seconds();
    for (int i = 0; i < steps; ++i)
        advance(scene.world, contacts, solver, scene.dt);
    return 1000 * (processor_seconds() - start) / steps;
}

/// @param falls, rests  [s]
StepTimes time_scene(Scene& scene, const Solver& solver, double falls, double rests)
{
    Contacts contacts;
    StepTimes times{time_steps(scene, contacts, solver, static_cast<int>(std::lround(falls / scene.dt))),
                    INFINITY};
    for (int block = 0; block < std::lround(rests / scene.dt / 20); ++block)
        times.at_rest = std::min(times.at_rest, time_steps(scene, contacts, solver, 20));
    return times;
}

ImplicitSettings one_thread()
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    settings.threads = threads;
    return settings;
}

Solver chapter_7(Scene& scene) { return chapter07_solver(scene.contact, one_thread()); }
Solver chapter_8(Scene& scene) { return chapter08_solver(scene.contact, one_thread()); }

struct Pile {
    std::string name;
    std::vector<Box> boxes;
    double falls;  ///< [s]
    double rests;  ///< long enough that the last cube of a heap has tipped over [s]
};

StepTimes time_pile(const Pile& pile, Solver (*make)(Scene&))
{
    Scene scene = scene_of(pile.boxes, 0.01);
    const Solver solver = make(scene);
    return time_scene(scene, solver, pile.falls, pile.rests);
}

/// Piles under the solvers of chapters 7 and 8, over Bullet's with its defaults.
void against_bullet(bool quick, Report& report)
{
    Table table({"pile", "chapter", "falling [ms]", "at rest [ms]", "Bullet, falling [ms]",
                 "Bullet, at rest [ms]", "ratio, falling", "ratio, at rest"});
    std::vector<Pile> piles{{"stack of 10", stack_of(10), 0.5, 2}};
    if (!quick)
        piles.insert(piles.end(), {{"heap of 20", loose_cubes(20, 3, 1), 1.5, 6},
                                   {"heap of 100", loose_cubes(100, 5, 1), 3, 8}});
    double worst = 0;  // of chapter 7
    for (const Pile& pile : piles) {
        const StepTimes bullet = time_pile(pile, bullet_solver);
        for (const auto& [chapter, make] : {std::pair{7L, &chapter_7}, std::pair{8L, &chapter_8}}) {
            const StepTimes ours = time_pile(pile, make);
            const double falling = ours.falling / bullet.falling, at_rest = ours.at_rest / bullet.at_rest;
            table.add({pile.name, chapter, ours.falling, ours.at_rest, bullet.falling, bullet.at_rest,
                       falling, at_rest});
            if (chapter == 7)
                worst = std::max({worst, falling, at_rest});
        }
    }
    report.table("speed_bullet", table);
    report.page_table("speed_bullet", table, 2);
    report.fact("speed", "worst_ratio_by_clock", worst, 2);
}

void growth(bool quick, Report& report)
{
    Table table({"cubes", "chapter 7 [ms]", "Bullet [ms]", "ratio"});
    std::vector<double> ours, bullet;
    const std::vector<int> counts = quick ? std::vector{20, 50} : std::vector{100, 300, 1000};
    for (const int cubes : counts) {
        const Pile pile{"stacks of 5", many_stacks(cubes), 1, 1};
        ours.push_back(time_pile(pile, chapter_7).at_rest);
        bullet.push_back(time_pile(pile, bullet_solver).at_rest);
        table.add({static_cast<long>(cubes), ours.back(), bullet.back(), ours.back() / bullet.back()});
    }
    report.table("speed_growth", table);
    report.page_table("speed_growth", table, 2);
    const auto exponent = [&](const std::vector<double>& times) {
        return growth_power(counts.front(), times.front(), counts.back(), times.back());
    };
    report.fact("speed", "exponent_by_clock", exponent(ours), 2);
    report.fact("speed", "bullet_exponent_by_clock", exponent(bullet), 2);
}

/// How a bunny is stepped.
struct BunnyRun {
    std::string chapter, basis, linear_solver;
};

/// Chapter 6's bunny in its bowl, and how much faster than its clock it runs.
void time_bunny(const BunnyRun& way, bool quick, Table& table, Report& report)
{
    const std::string elements = quick ? "363" : "785";
    Scene scene = load_scene(scene_file("bunny_at_rest"),
                             R"({"/bodies/bunny/shape/file": "bunny_)" + elements +
                                 R"(.msh", "/bodies/bunny/basis": ")" + way.basis +
                                 R"(", "/bodies/bunny/linear_solver": ")" + way.linear_solver + R"("})");
    SolveStatistics solves;
    long rounds = 0, newton_steps = 0;
    ImplicitSettings settings = one_thread();
    settings.record = [&](const SolveRecord& record) {
        solves.add(record);
        rounds += record.rounds;
        newton_steps += record.newton_steps;
    };
    const Solver solver = way.chapter == "7" ? chapter07_solver(scene.contact, settings)
                                             : chapter06_solver(scene.contact);
    const double falls = quick ? 0.2 : 2, rests = quick ? 0.2 : 1, step_ms = 1000 * scene.dt;
    const StepTimes times = time_scene(scene, solver, falls, rests);
    const double later = (quick ? falls + rests : scene.duration) - falls;  // as at rest
    const double all = (falls + later) * step_ms / (falls * times.falling + later * times.at_rest);
    const auto& bunny = dynamic_cast<const DeformableBody&>(*scene.world.bodies.back());
    const auto a_solve = [&](long count) {
        return solves.solves > 0 ? Cell(static_cast<double>(count) / static_cast<double>(solves.solves))
                                 : Cell("");
    };
    table.add({way.chapter, way.basis, way.linear_solver, times.falling, times.at_rest, a_solve(rounds),
               a_solve(newton_steps), static_cast<long>(bunny.elastic().factorisations()), all});
    if (way.linear_solver == "supernodal")
        report.fact("speed", "chapter_" + way.chapter + "_" + way.basis + "_bunny_real_time_factor_by_clock",
                    all, 2);
}

void bunnies(bool quick, Report& report)
{
    Table table({"chapter", "basis", "linear solver", "falling and landing [ms]", "at rest [ms]",
                 "rounds a solve", "Newton steps a solve", "elastic factors", "all, times real time"});
    for (const std::string basis : {"linear", "quadratic"})
        for (const std::string linear_solver : {"supernodal", "simplicial"})
            for (const std::string chapter : {"6", "7"})
                time_bunny({chapter, basis, linear_solver}, quick, table, report);
    report.table("speed_bunny", table);
    report.page_table("speed_bunny", table, 2);
}

}  // namespace

/// How long the steps of chapters 7 and 8 take, as ratios where this is possible.
void speed(const RunOptions& options, Report& report)
{
    against_bullet(options.quick, report);
    growth(options.quick, report);
    bunnies(options.quick, report);
    speed_of_matrices(options.quick, report);
    report.fact("speed", "threads", threads);
}

}  // namespace enduring::solvers
