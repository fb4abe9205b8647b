#include "chapters/06_redefinition/solver.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_deep_contacts/experiments/experiments.hpp"
#include "chapters/08_deep_contacts/solver.hpp"
#include "common/experiments/run/spring_ledger.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace enduring::chapter08 {
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

/// Cubes of 0.5 m and 20 kg exactly edge on edge, on a block of the same size that stands still, all turned
/// together by some angle so that coordinates are rounded. Each falls through the same gap [m].
World tower(int cubes, double turned, double gap)
{
    World world;
    const Mat3 turn = Eigen::AngleAxisd(turned, Vec3::UnitY()).toRotationMatrix();
    for (int i = 0; i <= cubes; ++i) {
        SurfaceMesh cube = box({0.5, 0.5, 0.5});
        for (Vec3& x : cube.vertices)
            x = turn * x + Vec3(0, (0.5 + gap) * i, 0);
        if (i == 0)
            world.bodies.push_back(std::make_unique<StaticBody>(
                "block", SurfaceTopology(static_cast<int>(cube.vertices.size()), cube.faces), cube.vertices));
        else
            world.bodies.push_back(rigid("cube " + std::to_string(i), cube, 20));
    }
    return world;
}

double energy(const World& world)
{
    double sum = 0;
    for (const auto& body : world.bodies)
        sum += body->energy(world.gravity).total();
    return sum;
}

/// What a run makes of its energy [J].
struct Gain {
    double most = 0;     ///< over that at first, after any step
    double brought = 0;  ///< by births and jumps, less what deaths took along; at most after any step
};

Gain gain_of(World world, const Solver& solver, int steps)
{
    const ContactParameters parameters;
    Contacts contacts;
    SpringLedger ledger(world, parameters.stiffness, parameters.leaving_speed);
    const double before = energy(world);
    Gain gain;
    for (int step = 0; step < steps; ++step) {
        advance(world, contacts, solver, 0.01);
        ledger.add_step(world, contacts, 0.01);
        const SpringAccounts& sums = ledger.accounts();
        gain.most = std::max(gain.most, energy(world) - before);
        gain.brought = std::max(gain.brought, sums.brought());
    }
    return gain;
}

struct Compared {
    std::string name;
    Solver (*make)(const ContactParameters&);
};
const std::vector<Compared> solvers{
    {"chapter_6", chapter06_solver}, {"chapter_7", chapter07_solver}, {"chapter_8", chapter08_solver}};

void laid_blocks(bool quick, Report& report, Table& table)
{
    const ContactParameters parameters{PenaltyMethod::continuous, 12000};
    std::array<double, 3> most{};
    long runs = 0;
    for (const double slope : quick ? std::vector<double>{10} : std::vector<double>{5, 10, 15, 20, 25, 30})
        for (const double turned : {0.0, 0.3, 0.6, std::numbers::pi / 4}) {
            ++runs;
            for (std::size_t i = 0; i < 3; ++i)
                most[i] = std::max(most[i],
                                   gain_of(laid_block(slope, turned), solvers[i].make(parameters), 80).most);
        }
    table.add({std::string("block laid exactly"), runs, most[0], most[1], most[2]});
    report.fact("born_loaded", "laid_6", most[0]);
    report.fact("born_loaded", "laid_7", most[1]);
    report.fact("born_loaded", "laid_8", most[2]);
}

//! [towers]
/// Towers of 1, 2 and 5 cubes: the energy that pairs bring which are born and die at a depth.
void towers(bool quick, Report& report, Table& table)
{
    // without friction a tower soon slides off its edges
    const ContactParameters parameters{PenaltyMethod::continuous, 12000,
                                       MassSplitting{.mu_s = 0.5, .mu_d = 0.4}};
    Table page(
        {"cubes", "gap_mm", "impact_j", "chapter_6_percent", "chapter_7_percent", "chapter_8_percent"});
    double worst = 0, gained = 0;
    for (const int cubes : {1, 2, 5}) {
        std::array<double, 3> most{};
        for (const double gap : {1e-4, 0.01}) {
            std::array<double, 3> percent{};
            double impact = 0;
            for (const double turned : {0.0, 0.1, 0.7})
                for (std::size_t i = 0; i < 3; ++i) {
                    const Gain gain = gain_of(tower(cubes, turned, gap), solvers[i].make(parameters),
                                              quick ? 60 : 600);
                    // what falls through the gaps that lie below it
                    impact = 20 * 9.81 * gap * cubes * (cubes + 1) / 2;
                    percent[i] = std::max(percent[i], 100 * gain.brought / impact);
                    most[i] = std::max(most[i], gain.most);
                }
            page.add({static_cast<long>(cubes), 1000 * gap, impact, percent[0], percent[1], percent[2]});
            worst = std::max(worst, percent[2]);
        }
        table.add({"tower of " + std::to_string(cubes), 6L, most[0], most[1], most[2]});
        gained = std::max(gained, most[2]);
    }
    report.table("tower", page);
    report.page_table("tower", page);
    report.fact("born_loaded", "tower_brought_percent", worst);
    report.fact("born_loaded", "tower_gained", gained);
}
//! [towers]

}  // namespace

/// Scenes in which pairs are born at a depth: the energy that they bring, under three solvers.
void born_loaded(const RunOptions& options, Report& report)
{
    Table table({"scene", "runs", "chapter_6_j", "chapter_7_j", "chapter_8_j"});
    laid_blocks(options.quick, report, table);
    towers(options.quick, report, table);
    report.table("born_loaded", table);
    report.page_table("born_loaded", table);
}

}  // namespace enduring::chapter08
