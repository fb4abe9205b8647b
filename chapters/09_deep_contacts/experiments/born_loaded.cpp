#include "chapters/06_redefinition/solver.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/experiments/towers.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/run/spring_ledger.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace enduring::chapter09 {
namespace {

std::unique_ptr<Body> rigid(const std::string& name, const SurfaceMesh& mesh, double mass)
{
    return std::make_unique<RigidBody>(name, mesh, with_mass(mass_properties(mesh, 1000), mass));
}

/// A block of 20 kg laid exactly on triangles, both turned together (chapter 6, "A block that is laid
/// exactly").
World laid_block(double slope_deg, double turned)
{
    const auto rotation = [](double angle, const Vec3& axis) {
        return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    };
    const Mat3 slope = rotation(slope_deg * std::numbers::pi / 180, Vec3::UnitZ()),
               turn = rotation(turned, Vec3::UnitY());
    SurfaceMesh slab = box({4, 0.4, 4}, {8, 1, 8}), block = box({1, 0.25, 1});
    for (Vec3& x : slab.vertices)
        x = slope * (x - Vec3(0, 0.2, 0));
    for (Vec3& x : block.vertices)
        x = slope * (turn * x + Vec3(0.125, 0.125, 0.125));
    World world;
    world.bodies.push_back(std::make_unique<StaticBody>(
        "slab", SurfaceTopology(static_cast<int>(slab.vertices.size()), slab.faces), slab.vertices));
    world.bodies.push_back(rigid("block", block, 20));
    return world;
}

double energy(const World& world)
{
    double sum = 0;
    for (const auto& body : world.bodies)
        sum += body->energy(world.gravity).total();
    return sum;
}

/// What a run makes of its energy and its bodies.
struct Gain {
    double most = 0;     ///< energy over that at first, after any step [J]
    double brought = 0;  ///< by initial overlaps and jumps, less what pairs that end took along; at most
                         ///< after any step [J]
    double sunk = 0;     ///< how far a body's middle came down, at most [m]
    double aside = 0;    ///< and how far across, at the end [m]

    void take_worse(const Gain& other)
    {
        most = std::max(most, other.most);
        brought = std::max(brought, other.brought);
        sunk = std::max(sunk, other.sunk);
        aside = std::max(aside, other.aside);
    }
};

std::vector<Vec3> middles_of(const World& world)
{
    std::vector<Vec3> middles;
    for (const auto& body : world.bodies)
        middles.push_back(body->centre());
    return middles;
}

Gain gain_of(World world, const Solver& solver, double dt, double duration)
{
    const ContactParameters parameters;
    Contacts contacts;
    SpringLedger ledger(world, parameters.stiffness, parameters.max_depenetration_velocity);
    const double before = energy(world);
    const std::vector<Vec3> first = middles_of(world);
    Gain gain;
    for (int step = 0; step < std::lround(duration / dt); ++step) {
        advance(world, contacts, solver, dt);
        ledger.add_step(world, contacts, dt);
        gain.most = std::max(gain.most, energy(world) - before);
        gain.brought = std::max(gain.brought, ledger.accounts().brought());
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
        const Vec3 way = world.bodies[i]->centre() - first[i];
        gain.sunk = std::max(gain.sunk, -way.y());
        gain.aside = std::max(gain.aside, std::hypot(way.x(), way.z()));
    }
    return gain;
}

struct LoadedWith {
    std::string name;
    Solver (*make)(const ContactParameters&);
};
const std::vector<LoadedWith> solvers{
    {"chapter_6", chapter06_solver}, {"chapter_8", chapter08_solver}, {"chapter_9", chapter09_solver}};

void laid_blocks(bool quick, Report& report, Table& table)
{
    const ContactParameters parameters{PenaltyMethod::continuous, 12000};
    std::array<double, 3> most{};
    long runs = 0;
    for (const double slope : quick ? std::vector<double>{10} : std::vector<double>{5, 10, 15, 20, 25, 30})
        for (const double turned : {0.0, 0.3, 0.6, std::numbers::pi / 4}) {
            ++runs;
            for (std::size_t i = 0; i < 3; ++i)
                most[i] = std::max(
                    most[i], gain_of(laid_block(slope, turned), solvers[i].make(parameters), 0.01, 0.8).most);
        }
    table.add({std::string("block laid exactly"), runs, most[0], most[1], most[2]});
    report.fact("born_loaded", "laid_6", most[0]);
    report.fact("born_loaded", "laid_8", most[1]);
    report.fact("born_loaded", "laid_9", most[2]);
}

//! [towers]
/// The towers of one height under one solver: of all the worst.
struct Towers {
    int cubes, runs = 0, fallen = 0;
    Gain worst{};
    double brought_percent = 0;  ///< of the impact

    void add(double gap, double turned, double dt, double duration, const Solver& solver)
    {
        const Gain gain = gain_of(tower(cubes, turned, gap), solver, dt, duration);
        // what falls through the gaps that lie below it
        const double way = gap * cubes, impact = 20 * 9.81 * gap * cubes * (cubes + 1) / 2;
        ++runs;
        fallen += gain.sunk > way + 0.01;
        worst.take_worse(gain);
        brought_percent = std::max(brought_percent, 100 * gain.brought / impact);
    }
};

Towers try_towers(int cubes, bool quick, Solver (*make)(const ContactParameters&))
{
    // without friction a tower soon slides off its edges
    const ContactParameters parameters{PenaltyMethod::continuous, 12000,
                                       MassSplitting{.mu_s = 0.5, .mu_d = 0.4}};
    Towers towers{.cubes = cubes};
    const bool few = quick || cubes > 10;
    for (const double gap : few ? std::vector{1e-4, 0.01} : std::vector{1e-5, 1e-4, 1e-3, 0.03})
        for (const double turned : few ? std::vector{0.0, 0.7} : std::vector{0.0, 0.1, 0.5, 0.7})
            for (const double dt : quick ? std::vector{0.01} : std::vector{0.005, 0.01, 1.0 / 60})
                towers.add(gap, turned, dt, quick ? 0.6 : 4, make(parameters));
    return towers;
}

/// Towers of equal cubes: the energy that pairs bring which begin and end at a depth, and whether they stand.
void towers(bool quick, Report& report, Table& table)
{
    Table page({"cubes", "runs", "fallen_chapter_6", "fallen_chapter_8", "fallen_chapter_9",
                "chapter_6_percent", "chapter_8_percent", "chapter_9_percent", "aside_chapter_8_mm",
                "aside_chapter_9_mm"});
    long runs = 0, fallen = 0;
    double brought = 0, gained = 0, aside_8 = 0, aside_9 = 0;
    for (const int cubes : quick ? std::vector{1, 2, 5} : std::vector{1, 2, 3, 5, 7, 20}) {
        std::vector<Towers> of;
        for (const LoadedWith& solver : solvers)
            of.push_back(try_towers(cubes, quick, solver.make));
        page.add({static_cast<long>(cubes), static_cast<long>(of[2].runs), static_cast<long>(of[0].fallen),
                  static_cast<long>(of[1].fallen), static_cast<long>(of[2].fallen), of[0].brought_percent,
                  of[1].brought_percent, of[2].brought_percent, 1000 * of[1].worst.aside,
                  1000 * of[2].worst.aside});
        table.add({"tower of " + std::to_string(cubes), static_cast<long>(of[2].runs), of[0].worst.most,
                   of[1].worst.most, of[2].worst.most});
        for (const Towers& mine : {of[1], of[2]}) {
            runs += mine.runs;
            fallen += mine.fallen;
            brought = std::max(brought, mine.brought_percent);
            gained = std::max(gained, mine.worst.most);
        }
        aside_8 = std::max(aside_8, of[1].worst.aside);
        aside_9 = std::max(aside_9, of[2].worst.aside);
    }
    report.table("tower", page);
    report.page_table("tower", page);
    report.fact("born_loaded", "tower_runs", static_cast<double>(runs));
    report.fact("born_loaded", "tower_fallen", static_cast<double>(fallen));
    constexpr double rounding = 1e-12;
    report.fact("born_loaded", "tower_brought_percent", brought < rounding ? 0 : brought);
    report.fact("born_loaded", "tower_gained", gained);
    report.fact("born_loaded", "tower_aside_8_mm", 1000 * aside_8, 2);
    report.fact("born_loaded", "tower_aside_9_mm", 1000 * aside_9, 2);
}
//! [towers]

}  // namespace

/// Scenes in which pairs begin at a depth: the energy that they bring, under three solvers.
void born_loaded(const RunOptions& options, Report& report)
{
    Table table({"scene", "runs", "chapter_6_j", "chapter_8_j", "chapter_9_j"});
    laid_blocks(options.quick, report, table);
    towers(options.quick, report, table);
    report.table("born_loaded", table);
    report.page_table("born_loaded", table);
}

}  // namespace enduring::chapter09
