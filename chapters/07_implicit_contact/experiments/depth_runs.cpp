#include "chapters/07_implicit_contact/experiments/depth_runs.hpp"

#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enduring::chapter07 {
namespace {

bool is_behind_a_plane(const World& world, const Body& body)
{
    return std::any_of(world.planes.begin(), world.planes.end(),
                       [&](const Plane& plane) { return plane.normal.dot(body.centre() - plane.point) < 0; });
}

}  // namespace

void DepthOutcome::add(const DepthOutcome& other)
{
    deepest_m = std::max(deepest_m, other.deepest_m);
    at_end_m = std::max(at_end_m, other.at_end_m);
    size_m = size_m == 0 ? other.size_m : std::min(size_m, other.size_m);
    gain = std::max(gain, other.gain);
    lost += other.lost;
    unsolved += other.unsolved;
    solves += other.solves;
    max_newton_steps = std::max(max_newton_steps, other.max_newton_steps);
}

DepthOutcome measure_depths(Scene& scene, double duration, MakeSolver make)
{
    DepthOutcome outcome;
    SolveStatistics solved;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) { solved.add(record); };
    const Solver solver = make(scene.contact, settings);
    World& world = scene.world;
    outcome.size_m = std::numeric_limits<double>::infinity();
    for (const auto& body : world.bodies)
        if (!body->is_static())
            outcome.size_m = std::min(outcome.size_m, body->size());
    Contacts contacts;
    const double first = total_energy(world).total();
    double last = first;
    const long steps = std::lround(duration / scene.dt);
    for (long i = 0; i < steps; ++i) {
        advance(world, contacts, solver, scene.dt);
        const double energy = total_energy(world).total() + spring_energy(contacts);
        outcome.gain = std::max(outcome.gain, (energy - last) / std::abs(first));
        last = energy;
        outcome.at_end_m = true_depth(world);
        outcome.deepest_m = std::max(outcome.deepest_m, outcome.at_end_m);
    }
    for (const auto& body : world.bodies)
        outcome.lost += !body->is_static() && is_behind_a_plane(world, *body);
    outcome.unsolved = solved.unconverged;
    outcome.solves = solved.solves;
    outcome.max_newton_steps = solved.max_newton_steps;
    return outcome;
}

}  // namespace enduring::chapter07
