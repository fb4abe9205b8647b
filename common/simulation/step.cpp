#include "common/simulation/step.hpp"

#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/joint_swing.hpp"
#include "common/simulation/step_attempt.hpp"
#include "common/simulation/turns.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace enduring {
namespace {

void run_passes(const std::vector<Pass>& passes, World& world, Contacts& contacts, double dt,
                const PassObserver& done)
{
    for (const Pass& pass : passes) {
        pass.run(world, contacts, dt);
        done(pass.name);
    }
}

/// A contact that lives on pushes from the start of the new step and has not been answered in it.
void begin_step(Contacts& contacts)
{
    for (Contact& contact : contacts) {
        contact.start = 0;
        contact.hold(contact.held());
        contact.impulse.setZero();
        contact.friction.setZero();
        contact.turning.setZero();
    }
}

void begin_step(std::vector<Joint>& joints)
{
    for (Joint& joint : joints)
        joint.acts = false;
}

bool any_waiting(const Contacts& contacts)
{
    return std::any_of(contacts.begin(), contacts.end(),
                       [](const Contact& contact) { return contact.waiting(); });
}

/// Whether a joint has not acted in this step.
bool any_waiting(const std::vector<Joint>& joints)
{
    return std::any_of(joints.begin(), joints.end(),
                       [](const Joint& joint) { return !joint.broken && !joint.acts; });
}

/// Stops a NaN where it first shows: every later number would only repeat it.
void require_finite(const World& world, const std::string& stage)
{
    for (const std::unique_ptr<Body>& body : world.bodies) {
        const std::span<const Vec3> positions = body->positions_t1();
        for (std::size_t vertex = 0; vertex < positions.size(); ++vertex)
            if (!positions[vertex].allFinite())
                throw std::runtime_error("step " + std::to_string(world.step + 1) + ": body '" +
                                         body->name() + "', vertex " + std::to_string(vertex) +
                                         ": the position " + stage + " is not a finite number");
    }
}

void predict(World& world, double dt)
{
    for (const std::unique_ptr<Body>& body : world.bodies) {
        body->set_time(world.time);
        body->predict(world.gravity, dt);
    }
    require_finite(world, "predicted from the body's own motion");
}

void update_predictions(World& world, double dt)
{
    for (const std::unique_ptr<Body>& body : world.bodies)
        body->update_prediction(dt);
    require_finite(world, "predicted after contact impulses");
}

void commit(World& world, double dt)
{
    for (const std::unique_ptr<Body>& body : world.bodies)
        body->commit(dt);
    world.time += dt;
}

}  // namespace

Solver::Solver(std::string of_solver, const std::vector<Pass>& refresh, const std::vector<Pass>& detect,
               const std::vector<Pass>& respond, const std::vector<Pass>& finish)
    : name(std::move(of_solver))
{
    const std::array lists{&refresh, &detect, &respond, &finish};
    for (std::size_t stage = 0; stage < lists.size(); ++stage)
        for (const Pass& pass : *lists[stage])
            append(static_cast<StepStage>(stage), pass);
}

const Pass& Solver::pass(const std::string& called) const
{
    const auto [list, index] = place_of(called);
    return lists_[list][index];
}

void Solver::append(StepStage stage, Pass pass)
{
    require_free(pass.name);
    lists_[static_cast<std::size_t>(stage)].push_back(std::move(pass));
}

void Solver::insert_before(const std::string& called, Pass pass)
{
    require_free(pass.name);
    const auto [list, index] = place_of(called);
    lists_[list].insert(lists_[list].begin() + static_cast<std::ptrdiff_t>(index), std::move(pass));
}

void Solver::replace(const std::string& called, Pass pass)
{
    const auto [list, index] = place_of(called);
    if (pass.name != called)
        require_free(pass.name);
    lists_[list][index] = std::move(pass);
}

void Solver::append(StepStage stage, std::string pass, Pass::Function run)
{
    append(stage, Pass{std::move(pass), std::move(run)});
}

void Solver::insert_before(const std::string& called, std::string pass, Pass::Function run)
{
    insert_before(called, Pass{std::move(pass), std::move(run)});
}

void Solver::replace(const std::string& called, std::string pass, Pass::Function run)
{
    replace(called, Pass{std::move(pass), std::move(run)});
}

void Solver::remove(const std::string& called)
{
    const auto [list, index] = place_of(called);
    lists_[list].erase(lists_[list].begin() + static_cast<std::ptrdiff_t>(index));
}

void Solver::wrap(const std::string& called, std::string pass, Around around)
{
    replace(called, std::move(pass),
            [inner = this->pass(called).run, around = std::move(around)](
                World& world, Contacts& contacts, double dt) { around(inner, world, contacts, dt); });
}

Solver::Place Solver::place_of(const std::string& called) const
{
    for (std::size_t list = 0; list < lists_.size(); ++list)
        for (std::size_t index = 0; index < lists_[list].size(); ++index)
            if (lists_[list][index].name == called)
                return {list, index};
    throw std::invalid_argument("solver \"" + name + "\" has no pass \"" + called + "\"; it has " +
                                all_names());
}

void Solver::require_free(const std::string& called) const
{
    for (const std::vector<Pass>& list : lists_)
        for (const Pass& pass : list)
            if (pass.name == called)
                throw std::invalid_argument("solver \"" + name + "\" has a pass \"" + called +
                                            "\" already; it has " + all_names());
}

std::string Solver::all_names() const
{
    std::string names;
    for (const std::vector<Pass>& list : lists_)
        for (const Pass& pass : list)
            names += (names.empty() ? "\"" : ", \"") + pass.name + '"';
    return names.empty() ? "none" : names;
}

void push_from_outside(World& world, std::size_t body, int vertex, const Vec3& impulse)
{
    world.bodies[body]->apply_impulse(vertex, impulse);
    world.attempt.from_outside.push_back({body, vertex, impulse});
}

//! [apply_impulses]
void apply_impulses(World& world, Contacts& contacts)
{
    for (Contact& contact : contacts) {
        if (!contact.waiting())
            continue;
        const Vec3 impulse = contact.impulse + contact.friction;
        for (int i = 0; i < contact.vertex_count(); ++i) {
            const auto vertex = static_cast<std::size_t>(i);
            body_of_vertex(world, contact, i)
                .apply_impulse(contact.vertices[vertex], contact.weights[vertex] * impulse);
        }
        contact.state = ContactState::answered;
    }
}
//! [apply_impulses]

namespace {

/// Whether the attempt at a step is given up here, before it ends.
bool is_given_up(const World& world)
{
    return world.attempt.may_be_halved && world.attempt.trouble != StepTrouble::none;
}

//! [advance]
void take_step(World& world, Contacts& contacts, const Solver& solver, double dt, const PassObserver& done)
{
    predict(world, dt);
    begin_step(contacts);
    begin_step(world.joints);
    done("predict");
    const Turns free_turns(world, dt);
    int& left = world.attempt.responses_left = solver.max_responses;
    run_passes(solver.passes(StepStage::refresh), world, contacts, dt, done);

    run_passes(solver.passes(StepStage::detect), world, contacts, dt, done);
    for (int n = 0; left > 0 && (any_waiting(contacts) || (n == 0 && any_waiting(world.joints))); ++n) {
        --left;
        run_passes(solver.passes(StepStage::respond), world, contacts, dt, done);
        apply_impulses(world, contacts);
        ++world.attempt.work.responses;
        done("apply impulses");
        update_predictions(world, dt);
        done("update prediction");
        if (free_turns.exceeded(world, solver.max_turn))
            world.attempt.trouble = StepTrouble::turns_too_far;
        if (is_given_up(world))
            return;
        run_passes(solver.passes(StepStage::detect), world, contacts, dt, done);
    }
    if (any_waiting(contacts) && world.attempt.trouble == StepTrouble::none)
        world.attempt.trouble = StepTrouble::unanswered;  // each response brings new pairs
    if (is_given_up(world))
        return;

    run_passes(solver.passes(StepStage::finish), world, contacts, dt, done);
    const double driven = driven_work(world, contacts, dt);
    world.driven += driven;
    world.attempt.added_energy += driven + turned_lever_work(world, dt);
    commit(world, dt);
    done("commit");
    run_passes(solver.passes(StepStage::after_commit), world, contacts, dt, done);
}
//! [advance]

//! [try_step]
/// Takes a step, and says in the world's attempt how it ended.
void try_step(World& world, Contacts& contacts, const Solver& solver, double dt, double behind,
              bool may_be_halved, const PassObserver& done)
{
    const HeldEnergy before = held_energy(world, contacts);
    world.attempt = {may_be_halved, StepTrouble::none, false, before.springs, 0, behind};
    try {
        take_step(world, contacts, solver, dt, done);
    } catch (const std::runtime_error&) {  // a number is not finite
        if (!may_be_halved)
            throw;
        world.attempt.trouble = StepTrouble::not_finite;
    }
    if (world.attempt.trouble == StepTrouble::none &&
        has_gained(world, before, held_energy(world, contacts), dt))
        world.attempt.trouble = StepTrouble::gains_energy;
}

/// Whether a body that nothing touches turns so far in a step that it has to be taken in halves from the
/// first, or swings so fast in its joints.
bool begins_too_long(const World& world, double max_turn, double dt)
{
    constexpr double max_parts = 1024;
    for (const auto& body : world.bodies) {
        const double turn = dt * body->turning_speed();
        if (turn > max_parts * max_turn) {
            std::ostringstream why;
            why << "step " << world.step + 1 << ": body '" << body->name() << "' turns by " << turn
                << " rad in a step; make dt shorter";
            throw std::runtime_error(why.str());
        }
        if (turn > max_turn)
            return true;
    }
    const double swing = world.joints.empty() ? 0 : joint_swing(world, dt);
    if (swing > max_parts * max_parts) {
        std::ostringstream why;
        why << "step " << world.step + 1
            << ": the forces of joints swing a body with omega dt = " << std::sqrt(swing)
            << "; its mass is too small, or make dt shorter";
        throw std::runtime_error(why.str());
    }
    return swing > most_joint_swing;
}

void advance_in_halves(World& world, Contacts& contacts, const Solver& solver, double dt, double behind,
                       int halvings, const PassObserver& done);

void advance_both_halves(World& world, Contacts& contacts, const Solver& solver, double dt, double behind,
                         int halvings, const PassObserver& done)
{
    advance_in_halves(world, contacts, solver, dt / 2, behind + dt / 2, halvings, done);
    advance_in_halves(world, contacts, solver, dt / 2, behind, halvings, done);
}

//! [learn]
/// Parts learn from parts: what is not solved in a longer part will not be solved in one in the next moment,
/// and the attempt would be lost. After a part that is solved, longer ones are tried again.
void learn(World& world, int halvings)
{
    const StepAttempt& attempt = world.attempt;
    if (attempt.trouble == StepTrouble::unsolved && attempt.may_be_halved)
        world.learned_halvings = halvings + 1;
    else if (attempt.trouble == StepTrouble::none && !attempt.is_kept_unsolved)
        world.learned_halvings = std::max(0, world.learned_halvings - 1);
}
//! [learn]

/// A step that does not end well is thrown away, and its halves are tried in its place.
/// @param behind    what of the whole step comes behind [s]
/// @param halvings  how often what is left of the step was halved because it had not ended well
void advance_in_halves(World& world, Contacts& contacts, const Solver& solver, double dt, double behind,
                       int halvings, const PassObserver& done)
{
    if (begins_too_long(world, solver.max_turn, dt)) {
        advance_both_halves(world, contacts, solver, dt, behind, halvings, done);
        return;
    }
    if (halvings < world.learned_halvings) {
        advance_both_halves(world, contacts, solver, dt, behind, halvings + 1, done);
        return;
    }
    const SavedState before(world, contacts);
    try_step(world, contacts, solver, dt, behind, halvings < solver.max_halvings, done);
    learn(world, halvings);
    world.work.add(world.attempt.work,
                   world.attempt.trouble == StepTrouble::none || !world.attempt.may_be_halved);
    if (world.attempt.trouble == StepTrouble::none)
        return;
    if (!world.attempt.may_be_halved) {
        ++world.ended_badly;
        ++world.work.ended_badly;
        return;
    }
    ++world.thrown_away;
    before.restore(world, contacts);
    advance_both_halves(world, contacts, solver, dt, behind, halvings + 1, done);
}
//! [try_step]

}  // namespace

void advance(World& world, Contacts& contacts, const Solver& solver, double dt, const PassObserver& done)
{
    world.whole_dt = dt;
    world.work = {};
    if (solver.max_halvings > 0) {
        advance_in_halves(world, contacts, solver, dt, 0, 0, done);
    } else {
        world.attempt = {};
        take_step(world, contacts, solver, dt, done);
        world.work.add(world.attempt.work, true);
    }
    ++world.step;
}

}  // namespace enduring
