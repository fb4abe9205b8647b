#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/bullet_baseline/bullet_solver.hpp"
#include "chapters/solvers/experiments.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::solvers {
namespace {

using chapter07::Box, chapter07::loose_cubes, chapter07::scene_of, chapter07::stack_of;

/// Processor time of a step, mean over some of a run's steps [ms].
struct StepTimes {
    double falling = 0, at_rest = 0;
};

/// @param lands  when what falls has come to rest [s]
StepTimes time_steps(Scene& scene, const Solver& solver, double lands, double duration)
{
    Contacts contacts;
    const auto per_step = [&](double until) {
        const int first = scene.world.step;
        const double start = processor_seconds();
        while (scene.world.time < until - 0.5 * scene.dt)
            advance(scene.world, contacts, solver, scene.dt);
        const int steps = scene.world.step - first;
        return steps > 0 ? 1000 * (processor_seconds() - start) / steps : 0;
    };
    const double falling = per_step(lands);
    return {falling, per_step(duration)};
}

Solver chapter_7(Scene& scene)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    return chapter07_solver(scene.contact, settings);
}

struct Pile {
    std::string name;
    std::vector<Box> boxes;
    double lands, duration;
};

StepTimes time_pile(const Pile& pile, Solver (*make)(Scene&))
{
    Scene scene = scene_of(pile.boxes, 0.01);
    const Solver solver = make(scene);
    return time_steps(scene, solver, pile.lands, pile.duration);
}

/// Piles under chapter 7's solver and under Bullet, with its defaults.
void against_bullet(bool quick, Report& report)
{
    Table table({"pile", "chapter 7, falling [ms]", "chapter 7, at rest [ms]", "Bullet, falling [ms]",
                 "Bullet, at rest [ms]", "ratio, falling", "ratio, at rest"});
    const double longer = quick ? 1 : 3;
    std::vector<Pile> piles{{"stack of 10", stack_of(10), 0.5, 0.5 + longer},
                            {"heap of 20", loose_cubes(20, 3, 1), 1.5, 1.5 + longer}};
    if (!quick)
        piles.push_back({"heap of 100", loose_cubes(100, 5, 1), 3, 6});
    double worst = 0;
    for (const Pile& pile : piles) {
        const StepTimes ours = time_pile(pile, chapter_7), bullet = time_pile(pile, bullet_solver);
        table.add({pile.name, ours.falling, ours.at_rest, bullet.falling, bullet.at_rest,
                   ours.falling / bullet.falling, ours.at_rest / bullet.at_rest});
        worst = std::max({worst, ours.falling / bullet.falling, ours.at_rest / bullet.at_rest});
    }
    report.table("speed_bullet", table);
    report.page_table("speed_bullet", table, 2);
    report.fact("speed", "worst_ratio", worst, 2);
}

/// Stacks of five, side by side without touching: ten times the cubes should be ten times the work.
std::vector<Box> many_stacks(int cubes)
{
    std::vector<Box> boxes;
    const int side = static_cast<int>(std::ceil(std::sqrt(cubes / 5)));
    for (int stack = 0; stack < cubes / 5; ++stack)
        for (Box box : stack_of(5)) {
            box.centre += 3 * Vec3(stack % side, 0, stack / side);
            boxes.push_back(box);
        }
    return boxes;
}

void growth(bool quick, Report& report)
{
    Table table({"cubes", "chapter 7 [ms]", "Bullet [ms]", "exponent since the row before", "Bullet's"});
    double before = 0, bullet_before = 0, cubes_before = 0, first = 0, exponent = 0;
    for (const int cubes : quick ? std::vector{25, 50} : std::vector{100, 200, 500, 1000}) {
        const Pile pile{"stacks of 5", many_stacks(cubes), 0.3, 0.6};
        const double ours = time_pile(pile, chapter_7).at_rest,
                     bullet = time_pile(pile, bullet_solver).at_rest;
        const auto grows = [&](double now, double then) {
            return then > 0 ? Cell(std::log(now / then) / std::log(cubes / cubes_before))
                            : Cell(std::string());
        };
        table.add(
            {static_cast<long>(cubes), ours, bullet, grows(ours, before), grows(bullet, bullet_before)});
        if (before == 0)
            first = ours / std::pow(cubes, 1.0);
        exponent = 1 + std::log(ours / cubes / first) / std::log(10);
        before = ours;
        bullet_before = bullet;
        cubes_before = cubes;
    }
    report.table("speed_growth", table);
    report.page_table("speed_growth", table, 2);
    if (!quick)
        report.fact("speed", "exponent", exponent, 2);
}

/// Chapter 6's bunny in its bowl, and how much faster than its clock it runs.
void bunny(bool quick, Report& report)
{
    Table table({"elements", "falling, times real time", "all, times real time"});
    for (const int elements : quick ? std::vector{363} : std::vector{363, 785, 1452}) {
        Scene scene = load_scene(scene_file("bunny_at_rest"), R"({"/bodies/bunny/shape/file": "bunny_)" +
                                                                  std::to_string(elements) + R"(.msh"})");
        const Solver solver = chapter_7(scene);
        const double duration = quick ? 0.6 : scene.duration, lands = duration / 2;
        const StepTimes times = time_steps(scene, solver, lands, duration);
        const double all = 0.5 * (times.falling + times.at_rest);
        table.add({static_cast<long>(elements), 1000 * scene.dt / times.falling, 1000 * scene.dt / all});
        if (elements == 785)
            report.fact("speed", "bunny_real_time", 1000 * scene.dt / all, 2);
    }
    report.table("speed_bunny", table);
    report.page_table("speed_bunny", table, 2);
}

}  // namespace

/// How long chapter 7's steps take, as ratios where this is possible.
void speed(const RunOptions& options, Report& report)
{
    against_bullet(options.quick, report);
    growth(options.quick, report);
    bunny(options.quick, report);
}

}  // namespace enduring::solvers
