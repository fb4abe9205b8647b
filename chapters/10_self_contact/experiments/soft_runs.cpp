#include "chapters/10_self_contact/experiments/soft_runs.hpp"

#include "chapters/10_self_contact/experiments/self_crossings.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/deformable_body.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace enduring::chapter10 {

SoftRun soft_run(const SoftVariant& variant)
{
    SoftRun run;
    Scene& scene = run.scene;
    scene.name = "folding";
    scene.dt = variant.dt;
    scene.contact.friction = MassSplitting{.mu_s = variant.mu, .mu_d = 0.8 * variant.mu};
    scene.camera = {{0.3, 0.3, 1.0}, {0.05, 0.12, 0}, 30};
    return run;
}

void add_soft(Scene& scene, const std::string& name, const TetrahedralMesh& mesh, const SoftVariant& variant,
              const Vec3& position, const Vec3& velocity, const std::vector<int>& fixed_nodes)
{
    DeformableSettings settings;
    settings.material = {.young = variant.young, .poisson = 0.3, .density = 1000, .stiffness_damping = 0.01};
    settings.impulse_response = ImpulseResponse::implicit;
    settings.self_contact = variant.self_contact;
    settings.position = position;
    settings.velocity = velocity;
    settings.fixed_nodes = fixed_nodes;
    scene.world.bodies.push_back(std::make_unique<DeformableBody>(name, mesh, settings));
}

Solver pulling(Solver solver, std::vector<Pull> pulls)
{
    if (pulls.empty())
        return solver;
    const std::string first = solver.passes(StepStage::refresh).front().name;
    solver.insert_before(first, "pull", [pulls = std::move(pulls)](World& world, Contacts&, double dt) {
        for (const Pull& pull : pulls) {
            if (world.time > pull.until - 0.5 * dt)
                continue;
            Body& body = *world.bodies[pull.body];
            const double part = pull.halved > 0 ? std::exp2(-world.time / pull.halved) : 1;
            for (const int vertex : pull.vertices)
                push_from_outside(world, static_cast<std::size_t>(pull.body), vertex,
                                  part * dt / static_cast<double>(pull.vertices.size()) * pull.force);
            body.update_prediction(dt);
        }
    });
    return solver;
}

double search_time(const Timings& timings)
{
    return timings.of("find pairs") + timings.of("find pairs brought inside");
}

namespace {

/// The sums over all bodies of a world.
struct Sums {
    Vec3 momentum = Vec3::Zero();
    double kinetic = 0, energy = 0, impulse = 0, depth = 0;
    long crossings = 0, inverted = 0;
};

/// @param depth  that is known already: only deeper crossings are measured
Sums sums_of(const World& world, double depth)
{
    Sums sums;
    for (const auto& body : world.bodies) {
        const Energy energy = body->energy(world.gravity);
        sums.kinetic += energy.kinetic;
        sums.energy += energy.total();
        sums.momentum += body->linear_momentum();
        sums.impulse += std::sqrt(2 * body->mass() * energy.kinetic);
        sums.inverted += body->inverted_elements();
        if (const RestNeighbours* neighbours = rest_neighbours(*body)) {
            const long crossings = self_crossings(*body, *neighbours);
            sums.crossings += crossings;
            if (crossings > 0)
                sums.depth = std::max(sums.depth, crossing_depth(*body, *neighbours, depth));
        }
    }
    return sums;
}

long own_pairs(const Contacts& contacts)
{
    return std::count_if(contacts.begin(), contacts.end(),
                         [](const Contact& c) { return !c.on_plane() && c.body_a == c.body_b; });
}

/// Adds up what the answers take, times the part of a step's pairs that are of a body with itself.
void clock_own_answers(Solver& solver, double& seconds)
{
    solver.wrap("solve contacts", "solve contacts",
                [&seconds](const Pass::Function& answer, World& world, Contacts& contacts, double dt) {
                    const double start = processor_seconds();
                    answer(world, contacts, dt);
                    if (!contacts.empty())
                        seconds += (processor_seconds() - start) * static_cast<double>(own_pairs(contacts)) /
                                   static_cast<double>(contacts.size());
                });
}

}  // namespace

Folded fold(SoftRun& soft, int steps, std::vector<Probe*> probes,
            std::function<bool(const World&, const Contacts&)> stop)
{
    Folded found;
    Sums first, now;
    double pulled = 0;
    for (const Pull& pull : soft.pulls)
        pulled = std::max(pulled, pull.until);
    WatchProbe watch([&](const World& world, const Contacts& contacts, double) {
        now = sums_of(world, found.depth);
        if (world.step == 0)
            first = now;
        found.pairs = std::max(found.pairs, own_pairs(contacts));
        found.crossings = std::max(found.crossings, now.crossings);
        found.depth = std::max(found.depth, now.depth);
        found.inverted = std::max(found.inverted, now.inverted);
        if (world.time <= pulled + 0.5 * soft.scene.dt)
            found.first = found.most = now.energy;
        found.most = std::max(found.most, now.energy);
        found.impact = std::max(found.impact, now.kinetic);
        found.impulse = std::max(found.impulse, now.impulse);
        found.momentum = std::max(found.momentum, (now.momentum - first.momentum).norm());
    });
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) {
        ++found.solves;
        found.unconverged += !record.converged;
    };
    probes.insert(probes.begin(), &watch);
    Solver solver = pulling(chapter10_solver(soft.scene.contact, settings), soft.pulls);
    double own_answers = 0;
    clock_own_answers(solver, own_answers);
    const RunResult result = run(soft.scene, solver, probes,
                                 failure_on_purpose({.steps = steps, .stop = std::move(stop)}));
    found.rest = now.kinetic;
    found.crossings_at_end = now.crossings;
    found.depth_at_end = sums_of(soft.scene.world, 0).depth;
    found.steps = result.steps;
    found.search_share = search_time(result.timings) / result.timings.total();
    found.answer_share = own_answers / result.timings.total();
    return found;
}

}  // namespace enduring::chapter10
