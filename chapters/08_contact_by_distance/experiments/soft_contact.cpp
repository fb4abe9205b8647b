#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/soft_contact_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/sweep.hpp"
#include "common/input/number_text.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace enduring::chapter08 {
namespace {

/// What a run with soft bodies came to. Plain numbers, to be kept by sweep().
struct SoftContact {
    double turned_away = 0;  ///< angular momentum that is lost at the end, over what the bodies had
    double gain = 0;    ///< most energy that a step brings, over what moved and was strained at most so far
    double height = 0;  ///< of the last body's middle at the end [m]
    double speed = 0;   ///< of its centre of mass [m/s]
    long inverted = 0;  ///< elements, the most after any step
    long unsolved = 0, solves = 0;
    long badly = 0;      ///< parts of steps that ended badly and could not be halved any more
    long halved = 0;     ///< attempts that were thrown away
    double seconds = 0;  ///< of the processor
    int torn = 0;        ///< links of a chain that have come apart at the end
};

enum class ElasticForces { linear_step, of_the_end };

SoftContact run_soft_contact(Scene& scene, double duration, ElasticForces forces = ElasticForces::of_the_end)
{
    SoftContact found;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) {
        ++found.solves;
        found.unsolved += !record.converged;
    };
    Solver solver = chapter08_solver(scene.contact, settings);
    if (forces == ElasticForces::linear_step)
        solver.remove("find elastic ends");
    World& world = scene.world;
    Contacts contacts;
    const Vec3 turned_at_first = angular_momentum(world);
    const double turning_at_first = turning(world);
    Energy energy = total_energy(world);
    double springs = 0, most = energy.kinetic + energy.elastic;
    const int steps = static_cast<int>(std::lround(duration / scene.dt));
    const std::clock_t begin = std::clock();
    for (int i = 0; i < steps; ++i) {
        advance(world, contacts, solver, scene.dt);
        const Energy before = std::exchange(energy, total_energy(world));
        const double springs_before = std::exchange(springs, spring_energy(contacts));
        most = std::max(most, energy.kinetic + energy.elastic);
        found.gain = std::max(found.gain,
                              (energy.total() + springs - before.total() - springs_before) / most);
        long inverted = 0;
        for (const auto& body : world.bodies)
            inverted += body->inverted_elements();
        found.inverted = std::max(found.inverted, inverted);
    }
    found.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    found.turned_away = (angular_momentum(world) - turned_at_first).norm() / turning_at_first;
    found.height = world.bodies.back()->centre().y();
    found.speed = world.bodies.back()->mean_velocity().norm();
    found.badly = world.ended_badly;
    found.halved = world.thrown_away;
    return found;
}

struct SoftTotals {
    double gain = 0;
    long runs = 0, inverted = 0, unsolved = 0, solves = 0, badly = 0, halved = 0;

    void add(const SoftContact& run)
    {
        ++runs;
        gain = std::max(gain, run.gain);
        inverted = std::max(inverted, run.inverted);
        unsolved += run.unsolved;
        solves += run.solves;
        badly += run.badly;
        halved += run.halved;
    }
    std::vector<Cell> cells() const { return {runs, inverted, 100 * gain, halved, badly, unsolved, solves}; }
};
const std::vector<std::string> total_columns{"runs",         "elements inverted", "most gain in a step [%]",
                                             "steps halved", "ended badly",       "unsolved",
                                             "solves"};

SoftTotals totals_of(const std::vector<SoftContact>& runs)
{
    SoftTotals all;
    for (const SoftContact& run : runs)
        all.add(run);
    return all;
}

/// Loses of angular momentum, over the step.
std::optional<SoftTotals> collisions(const RunOptions& options, Report& report)
{
    const std::vector<double> steps = options.quick ? std::vector{0.02, 0.01}
                                                    : std::vector{0.04, 0.02, 0.01, 0.005, 0.001};
    const std::vector<double> youngs = options.quick ? std::vector{1e5} : std::vector{1e4, 1e5, 1e7};
    const unsigned seeds = 2;
    std::vector<SoftCollision> runs;
    for (const Basis basis : {Basis::linear, Basis::quadratic})
        for (const double young : youngs)
            for (const double dt : steps)
                for (unsigned seed = 1; seed <= seeds; ++seed)
                    runs.push_back({basis, young, dt, seed});
    for (const int rigid : {1, 2})
        for (const double dt : steps)
            for (unsigned seed = 1; seed <= seeds; ++seed)
                runs.push_back({Basis::linear, youngs.front(), dt, seed, rigid});
    const auto found = sweep<SoftContact>(options, "soft collisions", runs.size(), [&](std::size_t i) {
        Scene scene = soft_collision(runs[i]);
        return run_soft_contact(scene, 0.5);
    });
    if (!found)
        return std::nullopt;
    std::vector<std::string> columns{"elements", "young_pa"};
    for (const double dt : steps)
        columns.push_back("lost at " + readable(1000 * dt, 2) + " ms [%]");
    Table table(columns);
    std::vector<double> worst(steps.size(), 0.0);
    auto run = found->begin();
    const auto lost_of_next = [&] {
        double lost = 0;
        for (unsigned seed = 1; seed <= seeds; ++seed, ++run)
            lost = std::max(lost, 100 * run->turned_away);
        return lost;
    };
    for (const Basis basis : {Basis::linear, Basis::quadratic})
        for (const double young : youngs) {
            std::vector<Cell> row{std::string(basis == Basis::linear ? "linear" : "quadratic"), young};
            for (double& worst_at : worst) {
                const double lost = lost_of_next();
                row.emplace_back(lost);
                worst_at = std::max(worst_at, lost);
            }
            table.add(row);
        }
    const auto add_rigid = [&](const std::string& cubes, const Cell& young, const std::string& fact) {
        std::vector<double> lost;
        for (std::size_t i = 0; i < steps.size(); ++i)
            lost.push_back(lost_of_next());
        std::vector<Cell> row{cubes, young};
        row.insert(row.end(), lost.begin(), lost.end());
        table.add(row);
        report.fact("soft_contact", fact, lost.front(), 2);
    };
    add_rigid("linear and rigid", youngs.front(), "lost_percent_mixed");
    add_rigid("both rigid", "", "lost_percent_rigid");
    report.table("soft_collisions", table);
    report.page_table("soft_collisions", table, 2);
    report.fact("soft_contact", "lost_percent_longest", worst.front(), 2);
    report.fact("soft_contact", "lost_percent_shortest", worst.back(), 2);
    return totals_of(*found);
}

/// Counts the links, too, that have come apart.
SoftContact run_chain(Scene& scene, double duration, ElasticForces forces)
{
    std::vector<int> linked;
    for (std::size_t ring = 1; ring < scene.world.bodies.size(); ++ring)
        linked.push_back(linking_number(scene, ring, ring - 1));
    SoftContact outcome = run_soft_contact(scene, duration, forces);
    for (std::size_t ring = 1; ring < scene.world.bodies.size(); ++ring)
        outcome.torn += linking_number(scene, ring, ring - 1) != linked[ring - 1];
    return outcome;
}

/// Chains: are they linked at the end?
std::optional<SoftTotals> chains(const RunOptions& options, Report& report)
{
    const std::vector<double> steps = options.quick ? std::vector{0.02}
                                                    : std::vector{0.04, 0.02, 0.01, 0.005};
    const std::vector<double> youngs = options.quick ? std::vector{1e5} : std::vector{1e4, 1e5, 1e6, 1e7};
    std::vector<SoftChain> runs;
    for (const int rings : {2, 3})
        for (const double young : youngs)
            for (const double dt : steps)
                runs.push_back({rings, young, dt});
    const auto found = sweep<SoftContact>(options, "soft chains", runs.size(), [&](std::size_t i) {
        Scene scene = soft_chain(runs[i]);
        return run_chain(scene, options.quick ? 0.6 : 1.5, ElasticForces::of_the_end);
    });
    if (!found)
        return std::nullopt;
    long torn = 0;
    for (const SoftContact& run : *found)
        torn += run.torn;
    report.fact("soft_contact", "torn", static_cast<double>(torn));
    return totals_of(*found);
}

/// What a cube of the base of 1 m^2 is pressed by its load [m].
double pressed_by(double mass, double young) { return 9.81 * mass / young; }

/// Heavy on light: does all rest at the right height?
std::optional<SoftTotals> soft_loads(const RunOptions& options, Report& report)
{
    struct Case {
        bool soft_on_top;
        double young, dt;
    };
    std::vector<Case> cases;
    for (const bool soft_on_top : {false, true})
        for (const double young : options.quick ? std::vector{1e6} : std::vector{2e5, 1e6, 1e7})
            for (const double dt : options.quick ? std::vector{0.025} : std::vector{0.025, 0.01})
                cases.push_back({soft_on_top, young, dt});
    const auto found = sweep<SoftContact>(options, "soft loads", cases.size(), [&](std::size_t i) {
        const Case& of = cases[i];
        Scene scene = of.soft_on_top ? cube_on_light_cube(of.young, of.dt)
                                     : chapter07::ton_on_block({1, of.young, 3}, of.dt);
        if (!of.soft_on_top)  // the load is the last body
            std::swap(scene.world.bodies[0], scene.world.bodies[1]);
        return run_soft_contact(scene, options.quick ? 1.0 : 4.0);
    });
    if (!found)
        return std::nullopt;
    Table table({"load", "young_pa", "dt_s", "sunk [mm]", "of a column [mm]", "speed_m_per_s"});
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Case& of = cases[i];
        const SoftContact& run = (*found)[i];
        const double start = of.soft_on_top ? 1.5 : 1.4;
        const double own = of.soft_on_top
                               ? 0.5
                               : 0;  // a soft load is pressed by half its own weight, to its middle by less
        table.add({std::string(of.soft_on_top ? "soft cube of 1 t" : "rigid cube of 1 t"), of.young, of.dt,
                   1000 * (start - run.height), 1000 * (1 + 0.5 * own) * pressed_by(1000, of.young),
                   run.speed});
    }
    report.table("soft_loads", table);
    report.page_table("soft_loads", table, 2);
    return totals_of(*found);
}

std::optional<SoftTotals> bunnies(const RunOptions& options)
{
    std::vector<chapter07::Bunnies> runs;
    for (const int elements : options.quick ? std::vector{363} : std::vector{363, 785})
        for (const double young : options.quick ? std::vector{1e4} : std::vector{1e4, 5e4})
            runs.push_back({1, elements, "linear", young});
    const auto found = sweep<SoftContact>(options, "soft bunnies", runs.size(), [&](std::size_t i) {
        Scene scene = chapter07::bunnies_in_bowl(runs[i], 0.01);
        return run_soft_contact(scene, options.quick ? 1.0 : 3.0);
    });
    if (!found)
        return std::nullopt;
    return totals_of(*found);
}

std::optional<SoftTotals> twisted_bars(const RunOptions& options)
{
    const std::vector<double> youngs = options.quick ? std::vector{1e6} : std::vector{1e4, 1e5, 1e6};
    const auto found = sweep<SoftContact>(options, "twisted bars", 2 * youngs.size(), [&](std::size_t i) {
        Scene scene = twisted_soft_bar(i < youngs.size() ? Basis::linear : Basis::quadratic,
                                       youngs[i % youngs.size()], 0.01);
        return run_soft_contact(scene, options.quick ? 0.3 : 1.0);
    });
    if (!found)
        return std::nullopt;
    return totals_of(*found);
}

/// The same scenes with one linear step of the elastic forces, and with those of the step's end.
void compare_forces(const RunOptions& options, Report& report)
{
    struct Case {
        std::string name;
        std::function<SoftContact(ElasticForces)> run;
    };
    const double longer = options.quick ? 1 : 2;
    std::vector<Case> cases;
    for (const double dt : options.quick ? std::vector{0.005} : std::vector{0.005, 0.002, 0.001})
        cases.push_back({"two cubes, dt " + readable(1000 * dt, 2) + " ms", [=](ElasticForces forces) {
                             Scene scene = soft_collision({Basis::linear, 1e5, dt, 1});
                             return run_soft_contact(scene, 0.4, forces);
                         }});
    cases.push_back({"three rings", [=](ElasticForces forces) {
                         Scene scene = soft_chain({3, 1e5, 0.02});
                         return run_chain(scene, 0.5 * longer, forces);
                     }});
    cases.push_back(
        {"bunny of 10 kPa", [=](ElasticForces forces) {
             Scene scene = chapter07::bunnies_in_bowl({1, longer > 1 ? 785 : 363, "linear", 1e4}, 0.01);
             return run_soft_contact(scene, longer, forces);
         }});
    cases.push_back({"twisted bar", [=](ElasticForces forces) {
                         Scene scene = twisted_soft_bar(Basis::linear, 1e6, 0.01);
                         return run_soft_contact(scene, 0.3 * longer, forces);
                     }});
    cases.push_back({"a ton on a block", [=](ElasticForces forces) {
                         Scene scene = chapter07::ton_on_block({1, 1e6, 3}, 0.025);
                         return run_soft_contact(scene, longer, forces);
                     }});
    const auto found = sweep<SoftContact>(options, "elastic forces", 2 * cases.size(), [&](std::size_t i) {
        return cases[i / 2].run(i % 2 == 0 ? ElasticForces::linear_step : ElasticForces::of_the_end);
    });
    if (!found)
        return;
    Table table({"scene", "elastic forces", "angular momentum lost [%]", "links torn", "elements inverted",
                 "most gain in a step [%]", "steps halved", "processor [s]"});
    double seconds[2] = {0, 0};
    for (std::size_t i = 0; i < found->size(); ++i) {
        const SoftContact& run = (*found)[i];
        const bool is_free = cases[i / 2].name.starts_with("two cubes");  // else something holds the bodies
        table.add({cases[i / 2].name, std::string(i % 2 == 0 ? "linear step" : "of the end"),
                   is_free ? Cell(100 * run.turned_away) : Cell(std::string("-")),
                   static_cast<long>(run.torn), run.inverted, 100 * run.gain, run.halved, run.seconds});
        seconds[i % 2] += run.seconds;
    }
    report.table("elastic_ends", table);
    report.page_table("elastic_ends", table, 2);
    report.fact("soft_contact", "time_ratio", seconds[1] / seconds[0], 2);
}

}  // namespace

/// Soft bodies that meet: angular momentum, inverted elements, links, heights, and the energy of every step.
void soft_contact(const RunOptions& options, Report& report)
{
    std::vector<std::string> columns{"scenes"};
    columns.insert(columns.end(), total_columns.begin(), total_columns.end());
    Table table(columns);
    const auto add = [&](const std::string& name, const std::optional<SoftTotals>& totals) {
        if (!totals)
            return;
        std::vector<Cell> row{name};
        const std::vector<Cell> cells = totals->cells();
        row.insert(row.end(), cells.begin(), cells.end());
        table.add(row);
        const std::string fact = name.substr(name.rfind(' ') + 1);
        report.fact("soft_contact", fact + "_inverted", static_cast<double>(totals->inverted));
        report.fact("soft_contact", fact + "_gain_percent", 100 * totals->gain, 2);
    };
    add("two soft cubes in collisions", collisions(options, report));
    add("linked soft rings", chains(options, report));
    add("a ton on light cubes as loads", soft_loads(options, report));
    add("soft bunnies", bunnies(options));
    add("twisted bars", twisted_bars(options));
    compare_forces(options, report);
    if (options.share.is_part())
        return;
    report.table("soft_contact", table);
    report.page_table("soft_contact", table, 2);
}

}  // namespace enduring::chapter08
