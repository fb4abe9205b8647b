#include "chapters/07_implicit_contact/anderson_mixing.hpp"
#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/07_implicit_contact/solver.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace enduring::chapter07 {
namespace {

/// How many rounds mixing combines.
struct Help {
    const char* name;
    int mixing_rounds;
};
const Help helps[] = {{"lagging alone", 0}, {"with mixing", ImplicitSettings{}.mixing_rounds}};
constexpr double tolerance = 1e-6;
constexpr int most_steps = 300;  ///< of Newton's method

struct Point {
    long newton_steps;
    double residual;
};

/// The rounds of one island, as solve_contacts() has them, without a search for limits.
std::vector<Point> rounds_of(World& world, const Island& island, const ImplicitSettings& settings,
                             const Help& help, double dt)
{
    StepProblem step = set_up(world, island, settings.stiffness, settings.friction, {settings.centre, dt},
                              true);
    apply_impulses(world, step, last_impulses(world, step));
    double mass = 0;
    for (const int body : island.bodies)
        mass += world.bodies[static_cast<std::size_t>(body)]->mass();
    const double least = std::sqrt(mass) * world.gravity.norm() * dt;
    NewtonMatrix matrix;
    AndersonMixing mixing(help.mixing_rounds);
    std::vector<Point> points;
    while (true) {
        update_kinematics(world, step);
        const ProblemSolution begin = unchanged(step.problem);
        const double residual = true_residual(step.problem, begin.change, least);
        points.push_back({matrix.solves(), residual});
        const int left = most_steps - matrix.solves();
        if (residual <= tolerance || left <= 0 || points.size() > most_steps)
            return points;
        const double of_round = residual_of(step.problem, begin.change, least),
                     sharp = std::min(std::max(0.1 * tolerance, 1e-3 * residual), 0.1 * of_round);
        const ProblemSolution solution = solve_convex(step.problem, matrix, begin,
                                                      std::max(1e-3 * tolerance, sharp), least,
                                                      std::min(left, max_convex_steps));
        apply_impulses(world, step, mixing.next(begin.impulses, solution.impulses));
    }
}

/// Which of the first steps takes the most of Newton's method, from 0.
int hardest_step(Scene scene, int steps)
{
    int newton_steps = 0;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) { newton_steps += record.newton_steps; };
    const Solver solver = chapter07_solver(scene.contact, settings);
    Contacts contacts;
    int hardest = 0, most = 0;
    for (int i = 0; i < steps; ++i) {
        newton_steps = 0;
        advance(scene.world, contacts, solver, scene.dt);
        if (newton_steps > most) {
            most = newton_steps;
            hardest = i;
        }
    }
    return hardest;
}

/// Solves the largest island of a step in this manner, after all steps before it were solved as ever.
std::vector<Point> rounds_of_step(Scene scene, int wanted, const Help& help)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    settings.friction = coefficients_of(scene.contact.friction);
    Solver solver = chapter07_solver(scene.contact, settings);
    Contacts contacts;
    for (int i = 0; i < wanted; ++i)
        advance(scene.world, contacts, solver, scene.dt);
    std::vector<Point> points;
    solver.replace("solve contacts", "measure rounds", [&](World& world, Contacts& all, double dt) {
        const std::vector<Island> islands = find_islands(world, all);
        if (points.empty() && !islands.empty())
            points = rounds_of(world,
                               *std::max_element(islands.begin(), islands.end(),
                                                 [](const Island& one, const Island& other) {
                                                     return one.contacts.size() < other.contacts.size();
                                                 }),
                               settings, help, dt);
        for (Contact& contact : all)
            if (contact.waiting())
                contact.state = ContactState::answered;
    });
    advance(scene.world, contacts, solver, scene.dt);
    return points;
}

}  // namespace

/// Three scenes: the residual on the bodies over the steps of Newton's method in the hardest step, and the
/// work of every fifth one.
void residual(const RunOptions& options, Report& report)
{
    struct Case {
        const char* name;
        Scene (*make)();
        int steps;
    };
    const std::vector<Case> cases{
        {"stack", [] { return scene_of(stack_of(10), 0.01); }, 60},
        {"heap", [] { return scene_of(loose_cubes(20, 3, 1), 0.01); }, options.quick ? 60 : 150},
        {"wedged", [] { return cube_between_planes(15, 0.5, 0.01); }, 60}};
    Table curves({"scene", "help", "newton_steps", "residual"});
    Table table({"scene", "rounds with", "Newton steps", "steps in touch", "unsolved"});
    for (const Case& scene : cases) {
        const int hardest = hardest_step(scene.make(), scene.steps);
        for (const Help& help : helps) {
            for (const Point& point : rounds_of_step(scene.make(), hardest, help))
                curves.add({scene.name, help.name, point.newton_steps, point.residual});
            long newton_steps = 0, touching = 0, unsolved = 0;
            for (int step = 4; step < scene.steps; step += 5)
                if (const std::vector<Point> points = rounds_of_step(scene.make(), step, help);
                    !points.empty()) {
                    ++touching;
                    newton_steps += points.back().newton_steps;
                    unsolved += points.back().residual > tolerance;
                }
            table.add({scene.name, help.name, newton_steps, touching, unsolved});
        }
    }
    report.table("residual", curves);
    report.page_table("residual", table, 2);
    report.plot("chapters/07_implicit_contact/plots/residual.gp");
}

}  // namespace enduring::chapter07
