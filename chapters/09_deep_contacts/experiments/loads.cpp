#include "chapters/09_deep_contacts/experiments/loads.hpp"

#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/run/energy_budget.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter09 {
namespace {

Scene on_the_ground(double dt)
{
    Scene scene;
    scene.name = "load";
    scene.dt = dt;
    scene.contact.friction = MassSplitting{.mu_s = 0.5, .mu_d = 0.4};
    scene.world.planes.push_back({"ground"});
    return scene;
}

/// @param place  of its middle at rest
/// @param above  how far above it begins [m]
void add_cube(Load& load, double side, int cells, const Vec3& place, double above, double mass)
{
    SurfaceMesh mesh = box(Vec3::Constant(side), {cells, cells, cells});
    for (Vec3& x : mesh.vertices)
        x += place + above * Vec3::UnitY();
    load.places.push_back(place);
    load.scene.world.bodies.push_back(std::make_unique<RigidBody>(
        "cube " + std::to_string(load.places.size()), mesh, with_mass(mass_properties(mesh, 1000), mass)));
}

Solver solver_of(int chapter, const Scene& scene, LoadOutcome& outcome)
{
    ImplicitSettings settings;
    settings.record = [&outcome](const SolveRecord& record) {
        ++outcome.solves;
        outcome.unconverged += !record.converged;
        outcome.newton_steps += record.newton_steps;
        outcome.max_newton_steps = std::max<long>(outcome.max_newton_steps, record.newton_steps);
    };
    return chapter == 8 ? chapter08_solver(scene.contact, settings)
                        : chapter09_solver(scene.contact, settings);
}

}  // namespace

Load load_of(const Pile& pile, double dt)
{
    Load load{on_the_ground(dt), {}};
    for (std::size_t i = 0; i < pile.masses.size(); ++i)
        add_cube(load, pile.side, pile.cells, (static_cast<double>(i) + 0.5) * pile.side * Vec3::UnitY(),
                 static_cast<double>(i + 1) * pile.gap, pile.masses[i]);
    return load;
}

Load block_on_dice(int cells, double gap, double dt)
{
    constexpr double die = 0.01, side = 0.2, middle = (side - die) / 2;
    Load load{on_the_ground(dt), {}};
    for (const double x : {-middle, middle})
        for (const double z : {-middle, middle})
            add_cube(load, die, cells, Vec3(x, die / 2, z), gap, 1e-3);
    add_cube(load, side, cells, Vec3(0, die + side / 2, 0), 2 * gap, 100);
    return load;
}

LoadOutcome watch(Load& load, int chapter, double duration)
{
    LoadOutcome outcome;
    Scene& scene = load.scene;
    const Solver solver = solver_of(chapter, scene, outcome);
    World& world = scene.world;
    EnergyBudget budget(scene);
    const double first = total_energy(world).total();
    Contacts contacts;
    for (int step = 1; step <= std::lround(duration / scene.dt); ++step) {
        advance(world, contacts, solver, scene.dt);
        if (budget.exceeded(world, contacts) && outcome.told_at == 0)
            outcome.told_at = step;
        outcome.gained = std::max(outcome.gained, total_energy(world).total() - first);
        outcome.height_mm = outcome.sideways_mm = outcome.speed = 0;
        for (std::size_t i = 0; i < load.places.size(); ++i) {
            const Vec3 off = world.bodies[i]->centre() - load.places[i];
            outcome.height_mm = std::max(outcome.height_mm, 1000 * std::abs(off.y()));
            outcome.sunk_mm = std::max(outcome.sunk_mm, -1000 * off.y());
            outcome.sideways_mm = std::max(outcome.sideways_mm, 1000 * std::hypot(off.x(), off.z()));
            outcome.speed = std::max(outcome.speed, world.bodies[i]->mean_velocity().norm());
        }
    }
    return outcome;
}

}  // namespace enduring::chapter09
