#include "chapters/06_redefinition/solver.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_deep_contacts/experiments/experiments.hpp"
#include "chapters/08_deep_contacts/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
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

/// Cubes of 0.5 m and 20 kg exactly edge on edge, turned together by some angle so that coordinates are
/// rounded.
World tower(int cubes, double turned)
{
    World world;
    world.planes.push_back({"ground", Vec3::Zero(), Vec3::UnitY()});
    const Mat3 turn = Eigen::AngleAxisd(turned, Vec3::UnitY()).toRotationMatrix();
    for (int i = 0; i < cubes; ++i) {
        SurfaceMesh cube = box({0.5, 0.5, 0.5});
        for (Vec3& x : cube.vertices)
            x = turn * x + Vec3(0, 0.25 + 0.5001 * i, 0);
        world.bodies.push_back(rigid("cube " + std::to_string(i + 1), cube, 20));
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

/// Most energy over that at first [J].
double most_gain(World world, const Solver& solver, int steps)
{
    Contacts contacts;
    const double before = energy(world);
    double most = 0;
    for (int step = 0; step < steps; ++step) {
        advance(world, contacts, solver, 0.01);
        most = std::max(most, energy(world) - before);
    }
    return most;
}

}  // namespace

/// Scenes in which pairs are born at a depth: the energy that they bring, under three solvers.
void born_loaded(const RunOptions& options, Report& report)
{
    struct Compared {
        std::string name;
        Solver (*make)(const ContactParameters&);
    };
    const std::vector<Compared> solvers{
        {"chapter_6", chapter06_solver}, {"chapter_7", chapter07_solver}, {"chapter_8", chapter08_solver}};
    const ContactParameters parameters{PenaltyMethod::continuous, 12000};
    Table table({"scene", "runs", "chapter_6_J", "chapter_7_J", "chapter_8_J"});
    std::vector<double> most(3, 0);
    long runs = 0;
    for (const double slope :
         options.quick ? std::vector<double>{10} : std::vector<double>{5, 10, 15, 20, 25, 30})
        for (const double turned : {0.0, 0.3, 0.6, std::numbers::pi / 4}) {
            ++runs;
            for (std::size_t i = 0; i < 3; ++i)
                most[i] = std::max(most[i],
                                   most_gain(laid_block(slope, turned), solvers[i].make(parameters), 80));
        }
    table.add({std::string("block laid exactly"), runs, most[0], most[1], most[2]});
    report.fact("born_loaded", "laid_6", most[0]);
    report.fact("born_loaded", "laid_7", most[1]);
    report.fact("born_loaded", "laid_8", most[2]);
    for (const int cubes : {2, 3, 5}) {
        std::fill(most.begin(), most.end(), 0);
        runs = 0;
        for (const double turned : {0.0, 0.1, 0.7}) {
            ++runs;
            for (std::size_t i = 0; i < 3; ++i)
                most[i] = std::max(most[i], most_gain(tower(cubes, turned), solvers[i].make(parameters),
                                                      options.quick ? 60 : 300));
        }
        table.add({"tower of " + std::to_string(cubes), runs, most[0], most[1], most[2]});
    }
    report.table("born_loaded", table);
    report.page_table("born_loaded", table);
}

}  // namespace enduring::chapter08
