#include "chapters/07_implicit_contact/implicit_contact.hpp"

#include "chapters/07_implicit_contact/anderson_mixing.hpp"
#include "chapters/07_implicit_contact/limit_search.hpp"
#include "chapters/07_implicit_contact/part_without_gain.hpp"
#include "chapters/07_implicit_contact/restitution.hpp"
#include "chapters/07_implicit_contact/rolling_friction.hpp"
#include "chapters/07_implicit_contact/whole_bodies.hpp"
#include "common/fem/elastic_body.hpp"
#include "common/simulation/turns.hpp"

#include <algorithm>
#include <cmath>
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

/// What springs hold where the bodies are at the start of the step [J].
double springs_at_start(const World& world, const StepProblem& step)
{
    double sum = 0;
    for (const Contact* contact : step.of_row) {
        const double compression = std::min(0.0, depth_at_start(world, *contact) - contact->rest_offset);
        sum += contact->stiffness / 2 * (compression * compression + contact->stretch.squaredNorm());
    }
    return sum;
}

/// The way that bodies which move as given take in the step against a pair's normal: they come nearer,
/// whatever the pair answers [m].
double driven_approach(const World& world, const Contact& contact, const Vec3& normal)
{
    double approach = 0;
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto vertex = static_cast<std::size_t>(i);
        if (const Body& body = body_of_vertex(world, contact, i); body.is_static())
            approach -= contact.weights[vertex] * normal.dot(body.position(contact.vertices[vertex], 1) -
                                                             body.position(contact.vertices[vertex], 0));
    }
    return std::max(0.0, approach);
}

/// How much farther a spring is pressed at the end of the step than at its start, over the size of its
/// smaller body; the most of all. What pressed it before no shorter step mends, nor what a drive presses.
double largest_compression(const World& world, const StepProblem& step)
{
    double most = 0;
    for (std::size_t i = 0; i < step.of_row.size(); ++i) {
        const PairRow& row = step.problem.rows[i];
        const Contact& contact = *step.of_row[i];
        const double depth_t0 = std::min(0.0, row.law.depth_t0),
                     depth_t1 = row.law.depth_t0 + step.problem.step.dt * row.law.normal.dot(row.velocity),
                     added = depth_t0 - depth_t1 - driven_approach(world, contact, row.law.normal);
        most = std::max(most, added / natural_length(world, contact));
    }
    return most;
}

/// By how much the pairs' impulses change, over what they become, both measured by the speed that they give
/// [1]. The residual would say too much: between stiff springs it is near 1 even where hardly anything moves,
/// so elements would follow in each round, and no two rounds could be mixed.
double changed_part(const ContactProblem& problem, const Eigen::VectorXd& before, const Eigen::VectorXd& next,
                    double least_speed)
{
    Eigen::VectorXd change = Eigen::VectorXd::Zero(problem.size), total = change;
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
        const auto place = static_cast<Eigen::Index>(3 * i);
        problem.rows[i].add_impulse(next.segment<3>(place) - before.segment<3>(place), change);
        problem.rows[i].add_impulse(next.segment<3>(place), total);
    }
    return residual_from(problem, change, total, least_speed);
}

//! [begin]
/// The impulses of the last step act on the bodies: at rest they are the answer. Where other pairs are in
/// touch now they balance no more, and a motion that turns a body too far for a step is no beginning: then
/// the free motion is.
void begin_with_last_impulses(World& world, StepProblem& step, double max_turn)
{
    const Turns free_turns(world, step.bodies, step.problem.step.dt);
    apply_impulses(world, step, last_impulses(world, step));
    if (free_turns.exceeded(world, max_turn))
        apply_impulses(world, step, Eigen::VectorXd::Zero(impulses_acting(step.problem).size()));
}
//! [begin]

/// The size of all pairs' impulses, each by the mass that its pair feels: pushes that cancel count, too
/// [sqrt(kg) m/s].
double speed_of_pairs(const StepProblem& step, const Eigen::VectorXd& impulses)
{
    double sum = 0;
    for (std::size_t i = 0; i < step.responses.size(); ++i)
        sum += impulses.segment<3>(static_cast<Eigen::Index>(3 * i)).squaredNorm() /
               mass_along(step.problem.rows[i].law.normal, step.responses[i]);
    return std::sqrt(sum);
}

//! [own_impulses]
/// Gives each pair what its own law says of the motion found, with the limit of friction that this motion
/// makes. Newton's tangents move the bodies in the same way, but leave open what no motion tells apart, as
/// among seven vertices or between the jaws of a vice. One more step of Newton's method, from the laws'
/// impulses, makes these add up to what moves the bodies.
/// @param enough  part of the impulses by which they may miss their laws as they are; what rounding makes of
///     them is enough, too
/// @return        steps of Newton's method: one, or none where the impulses obey their laws already
int take_own_impulses(World& world, StepProblem& step, NewtonMatrix& matrix, double enough)
{
    ContactProblem& problem = step.problem;
    for (PairRow& row : problem.rows)
        row.law.lagged_normal_impulse = normal_impulse(row.law, row.velocity, problem.step);
    const Answers answers = answers_to(problem, Eigen::VectorXd::Zero(problem.size));
    if (speed_of_pairs(step, answers.impulses - impulses_acting(problem)) <=
        std::max(enough * speed_of_pairs(step, answers.impulses), rounding_speed(world, step)))
        return 0;
    std::vector<Mat3> hessians;
    hessians.reserve(problem.rows.size());
    for (std::size_t i = 0; i < problem.rows.size(); ++i)
        hessians.push_back(problem.hessian_by(problem.rows[i], answers.pushes[i], problem.rows[i].velocity));
    const Eigen::VectorXd correction = matrix.solve(problem, hessians, answers.unbalanced);
    apply_impulses(world, step, matrix.tangent(answers.impulses, rates_of(problem, correction)));
    return 1;
}
//! [own_impulses]

/// What is found out about an island, beside its impulses.
struct IslandOutcome {
    SolveRecord record{};
    StepTrouble trouble = StepTrouble::none;
    double springs = 0;  ///< what they hold at the start of the step, where this is its first response [J]
    int solves = 0;      ///< of Newton's matrix in this response
};

//! [last_problem]
/// Where the rounds do not end: normals, levers and limits of friction stay those of the last motion, and
/// their convex problem is solved to its end. Its impulses belong to its motion, so they take energy only;
/// what errs is how much friction there is.
/// @param most  steps of Newton's method
/// @return      whether it is solved
bool solve_last_problem(World& world, StepProblem& step, NewtonMatrix& matrix,
                        const ImplicitSettings& settings, int most, double least, SolveRecord& record)
{
    if (most <= 0)
        return false;
    const ProblemSolution solution = solve_convex(step.problem, matrix, unchanged(step.problem),
                                                  settings.left_by_round * settings.kept_residual, least,
                                                  most);
    record.newton_steps += solution.newton_steps;
    apply_impulses(world, step, solution.impulses);
    update_kinematics(world, step);
    return solution.residual <= settings.kept_residual;
}
//! [last_problem]

//! [solve_contacts]
/// Changes the island's bodies and pairs only, and reads what does not move.
IslandOutcome solve_island(World& world, const Island& island, const ImplicitSettings& settings,
                           NewtonMatrix& matrix, const Allowance& allowed, bool first, double dt)
{
    StepProblem step = set_up(world, island, settings.stiffness, settings.friction, {settings.centre, dt},
                              first, settings.sparse_operation);
    add_rolling_rows(world, settings.friction, step);
    if (!island.elements.empty())
        settings.elements.add_rows(world, step);
    IslandOutcome outcome;
    if (first) {
        outcome.springs = springs_at_start(world, step);
        begin_with_last_impulses(world, step, settings.max_turn);
    }
    SolveRecord& record = outcome.record;
    record.pairs = static_cast<int>(step.of_row.size());
    outcome.solves = -matrix.solves();  // until now; at the end they are added
    const double least = least_speed(world, island, dt);
    // Forces of joints that cancel each other are not determined, and mixing would enlarge what rounding
    // makes of them.
    const int mixed = island.elements.empty() ? settings.mixing_rounds : 0;
    AndersonMixing mixing(mixed);
    const bool is_soft = follows_end(world, island), has_budget = !is_soft && island.elements.empty();
    const int most_steps = has_budget ? std::min(settings.max_newton_steps, allowed.newton_steps)
                                      : settings.max_newton_steps;
    double missing = 0;  // of elastic forces, as a part of what the step changes
    // Of velocities, back to before elements moved the pairs: springs are a thousand times as stiff, so a
    // problem begins there.
    Eigen::VectorXd before_move = Eigen::VectorXd::Zero(step.problem.size);
    for (;; ++record.rounds) {
        if (missing > small_imbalance) {
            before_move += velocities_of(world, step);
            missing = approach_ends(world, island, dt);
            before_move -= velocities_of(world, step);
            if (follow_elements(world, step))
                matrix.begin_response(matrix.solves());
            mixing = AndersonMixing(mixed);
        }
        update_kinematics(world, step);
        follow_rolling(world, settings.friction, step);
        if (!island.elements.empty())
            settings.elements.follow(world, step);
        const ProblemSolution begin = unchanged(step.problem);
        record.residual = true_residual(step.problem, begin.change, least);
        // the next round counts as one
        const int steps_left = most_steps - matrix.solves() - record.rounds - 1;
        if (record.residual <= settings.kept_residual && steps_left > 0 &&
            follow_levers(world, step, settings.lever_turn)) {
            matrix.begin_response(matrix.solves());
            continue;
        }
        record.converged = record.residual <= settings.tolerance ||
                           record.residual <= rounding_residual(world, step, least);
        if (record.converged && (first || record.rounds > 0))
            record.newton_steps += take_own_impulses(world, step, matrix, settings.tolerance_of_laws);
        if (record.converged && stiffen_where_pressed(world, step, settings.stiffness))
            continue;
        if (record.converged || steps_left <= 0)
            break;
        const double of_round = residual_of(step.problem, begin.change, least);
        const double sharp = std::max(settings.tolerance_of_laws,
                                      settings.left_by_round * std::min(record.residual, of_round));
        const ProblemSolution solution =
            record.rounds < settings.rounds_before_search
                ? solve_convex(step.problem, matrix,
                               {std::exchange(before_move, begin.change), begin.impulses}, sharp, least,
                               std::min(steps_left, max_convex_steps))
                : solve_with_limit_search(step.problem, matrix, begin, sharp, least, steps_left);
        record.newton_steps += solution.newton_steps;
        const Eigen::VectorXd next = mixing.next(begin.impulses, solution.impulses);
        if (is_soft)  // their elements feel what contact changes
            missing += changed_part(step.problem, begin.impulses, next, least);
        apply_impulses(world, step, next);
    }
    const int steps_left = settings.max_newton_steps - matrix.solves() - record.rounds;
    const bool is_lagged =
        has_budget && allowed.is_last && !record.converged && !(record.residual <= settings.kept_residual) &&
        solve_last_problem(world, step, matrix, settings,
                           std::min(steps_left, settings.budget.of_last_problem), least, record);
    if ((is_lagged || !world.attempt.may_be_halved) &&
        island.elements.empty())  // a part of a joint's impulses holds nothing
        if (const double part = part_without_gain(world, step); part < 1)
            apply_impulses(world, step, part * impulses_acting(step.problem));
    // what rounding leaves of hardly any impulse no shorter step mends
    if (!is_lagged && !record.converged && !(record.residual <= settings.kept_residual))
        outcome.trouble = StepTrouble::unsolved;
    else if (largest_compression(world, step) > settings.kept_depth)
        outcome.trouble = StepTrouble::too_deep;
    find_slip(step);
    if (!island.elements.empty())
        settings.elements.remember(world, step);
    outcome.solves += matrix.solves();
    return outcome;
}
//! [solve_contacts]

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
    for (const IslandOutcome& outcome : outcomes) {
        add(outcome, record, world);
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
        body->reach_end(dt);
}
//! [elastic_ends]

bool follows_end(const World& world, const Island& island)
{
    return std::any_of(island.bodies.begin(), island.bodies.end(), [&](int body) {
        return world.bodies[static_cast<std::size_t>(body)]->approaches_end();
    });
}

double approach_ends(World& world, const Island& island, double dt)
{
    double most = 0;
    for (const int place : island.bodies)
        if (Body& body = *world.bodies[static_cast<std::size_t>(place)]; body.approaches_end())
            most = std::max(most, body.approach_end(dt));
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
