#include "chapters/08_contact_by_distance/experiments/constants.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/harsh_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/shapes.hpp"
#include "chapters/08_contact_by_distance/experiments/soft_piles.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/sweep.hpp"
#include "common/input/number_text.hpp"
#include "common/simulation/step_attempt.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enduring::chapter08 {
namespace {

/// A constant by its place in the settings.
struct Constant {
    std::string name;
    std::function<void(ImplicitSettings&, double)> scale;
};

std::vector<Constant> constants_of_settings()
{
    const auto count = [](int value, double by) {
        return std::max(1, static_cast<int>(std::lround(value * by)));
    };
    return {
        {"h = k dt^2 / m", [](auto& s, double by) { s.stiffness.k_dt2_over_m *= by; }},
        {"largest h", [](auto& s, double by) { s.stiffness.max_k_dt2_over_m *= by; }},
        {"wanted depth", [](auto& s, double by) { s.stiffness.parts.wanted_depth *= by; }},
        {"part of the rest offset that fades in a step",
         [](auto& s, double by) { s.stiffness.keep = std::max(0.0, 1 - by * (1 - s.stiffness.keep)); }},
        {"speed at which a rest offset fades",
         [](auto& s, double by) { s.stiffness.parts.max_depenetration_velocity *= by; }},
        {"tolerance", [](auto& s, double by) { s.tolerance *= by; }},
        {"residual with which a step is kept", [](auto& s, double by) { s.kept_residual *= by; }},
        {"depth with which a step is kept", [](auto& s, double by) { s.kept_depth *= by; }},
        {"bound on Newton's method",
         [count](auto& s, double by) { s.max_newton_steps = count(s.max_newton_steps, by); }},
        {"rounds that mixing combines",
         [count](auto& s, double by) { s.mixing_rounds = count(s.mixing_rounds, by); }},
        {"rounds before the limits are searched",
         [count](auto& s, double by) { s.rounds_before_search = count(s.rounds_before_search, by); }},
    };
}

}  // namespace

std::vector<ChangedConstant> changed_constants()
{
    std::vector<ChangedConstant> all{{"none", "1", [](ImplicitSettings&) {}}};
    for (const Constant& constant : constants_of_settings())
        for (const double by : {0.1, 10.0})
            all.push_back({constant.name, by < 1 ? "1/10" : "10",
                           [constant, by](ImplicitSettings& settings) { constant.scale(settings, by); }});
    for (const auto& [text, weight] : {std::pair{"1/2", 0.5}, std::pair{"2/3", 2.0 / 3}})
        all.push_back({"weight a over the step; it is 1", text,
                       [weight = weight](ImplicitSettings& settings) { settings.centre = weight; }});
    return all;
}

void ConstantsOutcome::add(const ConstantsOutcome& other)
{
    deepest_m = std::max(deepest_m, other.deepest_m);
    at_end_m = std::max(at_end_m, other.at_end_m);
    speed = std::max(speed, other.speed);
    gain = std::max(gain, other.gain);
    newton_steps += other.newton_steps;
    parts += other.parts;
    steps += other.steps;
    unsolved += other.unsolved;
    stopped = stopped || other.stopped;
}

ConstantsOutcome run_with(const ChangedConstant& constant, Scene scene, int steps)
{
    ConstantsOutcome outcome;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) { outcome.newton_steps += record.newton_steps; };
    constant.change(settings);
    const Solver solver = chapter08_solver(scene.contact, settings);
    World& world = scene.world;
    Contacts contacts;
    double energy = held_energy(world, contacts).total;
    const double scale = std::max(std::abs(energy), held_energy(world, contacts).moving);
    try {
        while (outcome.steps < steps) {
            const std::vector<Vec3> before = chapter07::centres_of(world);
            advance(world, contacts, solver, scene.dt,
                    [&](const std::string& pass) { outcome.parts += pass == "commit"; });
            ++outcome.steps;
            outcome.at_end_m = chapter07::true_depth(world);
            outcome.deepest_m = std::max(outcome.deepest_m, outcome.at_end_m);
            outcome.speed = chapter07::longest_displacement(world, before) / scene.dt;
            const double after = held_energy(world, contacts).total;
            outcome.gain = std::max(outcome.gain, (after - energy) / scale);
            energy = after;
        }
    } catch (const std::runtime_error&) {
        outcome.stopped = true;
    }
    outcome.unsolved = world.ended_badly;
    return outcome;
}

Scene constants_scene(int index, bool quick)
{
    switch (index) {
        case 0: return chapter07::scene_of(chapter07::stack_of(quick ? 4 : 10), 0.01);
        case 1: return random_heap({mixed_family, quick ? 4 : 16, 0.01, 0.5, 1});
        case 2: return chapter07::scene_of(chapter07::stack_of(2, 1, 1000), 0.01);
        case 3: return soft_stack({quick ? 1 : 3, 1e5, 0.01});
        default: return std::move(harsh_scene(29, false).scene);
    }
}

namespace {

/// The runs of one change: the worst of all, and of those in which bodies come to rest.
struct Summary {
    ConstantsOutcome worst, resting;
    long stopped = 0;
};

Summary summary_of(const ConstantsOutcome* runs, int scenes)
{
    Summary sum;
    for (int scene = 0; scene < scenes; ++scene) {
        sum.worst.add(runs[scene]);
        sum.stopped += runs[scene].stopped;
        if (scene == 0 || scene == 2)  // the stack and 1,000 : 1; the others still move
            sum.resting.add(runs[scene]);
    }
    return sum;
}

void report_facts(const std::string& of, const Summary& sum, Report& report)
{
    report.fact("constants", of + "_gain_percent", 100 * sum.worst.gain, 2);
    report.fact("constants", of + "_fastest_mm_per_s", 1e3 * sum.resting.speed, 2);
    report.fact("constants", of + "_deepest_mm", 1e3 * sum.worst.deepest_m, 2);
    report.fact("constants", of + "_ended_badly", static_cast<double>(sum.worst.unsolved));
}

}  // namespace

/// A tenth and ten times of every constant of the solver, and other weights over the step.
void constants(const RunOptions& options, Report& report)
{
    const std::vector<ChangedConstant> all = changed_constants();
    const int scenes = options.quick ? constants_scenes - 1 : constants_scenes;
    const int steps = options.quick ? 30 : 200;
    const auto of_scenes = static_cast<std::size_t>(scenes);
    const auto found = sweep<ConstantsOutcome>(
        options, "constants", all.size() * of_scenes, [&](std::size_t i) {
            const auto scene = static_cast<int>(i % of_scenes);
            const bool is_harsh = scene == constants_scenes - 1;
            return run_with(all[i / of_scenes], constants_scene(scene, options.quick),
                            is_harsh ? harsh_steps : steps);
        });
    if (!found)
        return;
    Table table({"constant", "of its value", "deepest [mm]", "at rest [mm]", "fastest at rest [mm/s]",
                 "gain in a step [%]", "Newton steps / as it is", "parts of a step", "ended badly",
                 "stopped"});
    const double newton_as_is =
        static_cast<double>(std::max(1L, summary_of(found->data(), scenes).worst.newton_steps));
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Summary sum = summary_of(&(*found)[i * of_scenes], scenes);
        table.add({all[i].name, all[i].of_its_value, 1e3 * sum.worst.deepest_m, 1e3 * sum.resting.at_end_m,
                   1e3 * sum.resting.speed, 100 * sum.worst.gain,
                   static_cast<double>(sum.worst.newton_steps) / newton_as_is,
                   static_cast<double>(sum.worst.parts) / static_cast<double>(std::max(1L, sum.worst.steps)),
                   sum.worst.unsolved, sum.stopped});
        if (i < 2)
            report_facts(i == 0 ? "as_is" : "soft", sum, report);
        if (i + 2 >= all.size())
            report_facts(i + 1 == all.size() ? "two_thirds" : "half", sum, report);
    }
    report.table("constants", table);
    report.page_table("constants", table, 2);
}

}  // namespace enduring::chapter08
