#include "chapters/07_implicit_contact/implicit_contact.hpp"

#include "chapters/07_implicit_contact/island_solve.hpp"
#include "chapters/07_implicit_contact/restitution.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

namespace enduring {
namespace {

bool first_of_the_step(const Contacts& contacts)
{
    return std::none_of(contacts.begin(), contacts.end(),
                        [](const Contact& contact) { return contact.answered(); });
}

/// Takes what was found out about an island into the record and the attempt of the whole step.
void add(const IslandOutcome& outcome, SolveRecord& all, World& world)
{
    ++all.islands;
    all.unsolved_islands += !outcome.record.converged;
    all.pairs += outcome.record.pairs;
    all.rounds = std::max(all.rounds, outcome.record.rounds);
    all.newton_steps = std::max(all.newton_steps, outcome.record.newton_steps);
    all.residual = std::max(all.residual, outcome.record.residual);
    all.converged = all.unsolved_islands == 0;
    world.attempt.added_energy += outcome.springs;
    world.attempt.is_kept_unsolved = world.attempt.is_kept_unsolved || outcome.is_lagged;
    // an island that is not solved says more than one that is solved too deep
    if (outcome.trouble == StepTrouble::unsolved || world.attempt.trouble == StepTrouble::none)
        world.attempt.trouble = outcome.trouble;
}

/// Counts what a response cost.
void count(const std::vector<IslandOutcome>& outcomes, const SolveRecord& all, StepWork& work)
{
    work.islands = std::max(work.islands, static_cast<long>(all.islands));
    for (const IslandOutcome& outcome : outcomes) {
        work.rounds += outcome.record.rounds;
        work.newton_steps += outcome.solves;
    }
    work.unsolved += all.unsolved_islands;
    work.residual = std::max(work.residual, all.residual);
}

}  // namespace

void tell_unconverged(const SolveRecord& record)
{
    if (!record.converged)
        std::cerr << "step " << record.step + 1 << ": the impulses of " << record.pairs
                  << " pairs are solved to a residual of " << record.residual << " only, after "
                  << record.rounds << " rounds and " << record.newton_steps
                  << " steps of Newton's method; unsolved are " << record.unsolved_islands << " of "
                  << record.islands << " islands\n";
}

//! [islands]
void solve_contacts(World& world, Contacts& contacts, const ImplicitSettings& settings,
                    IslandMatrices& matrices, StepBudget& budget, double dt)
{
    const bool first = first_of_the_step(contacts);
    const std::vector<ElementBodies> elements = settings.elements.any() ? settings.elements.bodies(world)
                                                                        : std::vector<ElementBodies>{};
    const std::vector<Island> islands = find_islands(world, contacts, elements);
    matrices.begin_response(islands, world.bodies.size(), first);
    int pairs = 0;
    for (const Island& island : islands)
        pairs += static_cast<int>(island.contacts.size());
    budget.begin_response(world, settings.budget, pairs);
    std::vector<IslandOutcome> outcomes(islands.size());
    const bool is_small = contacts.size() < static_cast<std::size_t>(settings.pairs_for_threads);
    for_each_index(islands.size(), is_small ? 1 : settings.threads, [&](std::size_t i) {
        NewtonMatrix& matrix = matrices.of(islands[i]);
        const Allowance allowed = budget.of_island(world, settings.budget, matrix.solves(), dt);
        outcomes[i] = solve_island(world, islands[i], settings, matrix, allowed, first, dt);
    });

    if (first)
        world.attempt.added_energy -= world.attempt.springs;
    SolveRecord record{world.step};
    world.attempt.held_up.clear();
    for (std::size_t i = 0; i < islands.size(); ++i) {
        const IslandOutcome& outcome = outcomes[i];
        add(outcome, record, world);
        if (outcome.is_held_up)
            world.attempt.held_up.push_back(islands[i].bodies);
        budget.take(outcome.solves, static_cast<double>(outcome.record.pairs) / std::max(1, pairs));
    }
    count(outcomes, record, world.attempt.work);
    for (Contact& contact : contacts)
        if (contact.waiting())
            contact.state = ContactState::answered;
    if (world.attempt.trouble == StepTrouble::none || !world.attempt.may_be_halved)
        settings.record(record);
}
//! [islands]

void solve_contacts(World& world, Contacts& contacts, const ImplicitSettings& settings,
                    IslandMatrices& matrices, double dt)
{
    StepBudget budget;
    solve_contacts(world, contacts, settings, matrices, budget, dt);
}

//! [elastic_ends]
void find_elastic_ends(World& world, double dt)
{
    for (const auto& body : world.bodies)
        body->inner_forces().reach_end(dt);
}
//! [elastic_ends]

bool follows_end(const World& world, const Island& island)
{
    return std::any_of(island.bodies.begin(), island.bodies.end(), [&](int body) {
        return world.bodies[static_cast<std::size_t>(body)]->inner_forces().approaches_end();
    });
}

double approach_ends(World& world, const Island& island, double dt)
{
    double most = 0;
    for (const int place : island.bodies)
        if (InnerForces& forces = world.bodies[static_cast<std::size_t>(place)]->inner_forces();
            forces.approaches_end())
            most = std::max(most, forces.approach_end(dt));
    return most;
}

//! [add_solve]
void add_solve(Solver& solver, const ContactParameters& parameters, ImplicitSettings settings)
{
    settings.friction = coefficients_of(parameters);
    settings.max_turn = solver.max_turn;
    if (parameters.wanted_depth)
        settings.stiffness.wanted_depth = parameters.wanted_depth;
    if (parameters.max_depenetration_velocity)
        settings.stiffness.max_depenetration_velocity = parameters.max_depenetration_velocity;
    solver.max_halvings = max_halvings;
    solver.finds_stiffness = true;
    solver.has_surface_laws = true;
    const std::string first = solver.passes(StepStage::refresh).front().name;
    solver.insert_before(first, "find elastic ends",
                         [](World& world, Contacts&, double dt) { find_elastic_ends(world, dt); });
    solver.append(StepStage::respond, "solve contacts",
                  [settings, matrices = std::make_shared<IslandMatrices>(),
                   budget = std::make_shared<StepBudget>()](World& world, Contacts& contacts, double dt) {
                      solve_contacts(world, contacts, settings, *matrices, *budget, dt);
                  });
    solver.append(StepStage::finish, "remember pairs", remember_pairs);
    solver.append(StepStage::after_commit, "restitution",
                  [friction = settings.friction](World& world, Contacts& contacts, double dt) {
                      restitute(world, contacts, friction, dt);
                  });
}
//! [add_solve]

}  // namespace enduring
