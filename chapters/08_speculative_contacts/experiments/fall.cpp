#include "chapters/08_speculative_contacts/experiments/fall.hpp"

#include "common/simulation/energy.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter08 {

FallOutcome watch(Scene& scene, double duration, MakeSolver make, Probe* observer)
{
    FallOutcome outcome;
    long newton_steps = 0;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) {
        outcome.solves.add(record);
        newton_steps += record.newton_steps;
    };
    const Solver solver = make(scene.contact, settings);
    World& world = scene.world;
    Contacts contacts;
    const double first = total_energy(world).total();
    const long steps = std::lround(duration / scene.dt);
    if (observer)
        observer->observe(world, contacts, scene.dt);
    for (long i = 0; i < steps; ++i) {
        advance(world, contacts, solver, scene.dt);
        outcome.energy_gain_j = std::max(outcome.energy_gain_j, total_energy(world).total() - first);
        for (const auto& body : world.bodies)
            for (const Vec3& vertex : body->positions_t0())
                outcome.deepest_mm = std::max(outcome.deepest_mm, -1000 * vertex.y());
        if (observer)
            observer->observe(world, contacts, scene.dt);
    }
    outcome.pairs = static_cast<long>(contacts.size());
    for (const auto& body : world.bodies)
        outcome.speed_mm_per_s = std::max(outcome.speed_mm_per_s, 1000 * body->mean_velocity().norm());
    outcome.newton_steps = static_cast<double>(newton_steps) / static_cast<double>(steps);
    return outcome;
}

}  // namespace enduring::chapter08
