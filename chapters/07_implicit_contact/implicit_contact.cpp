#include "chapters/07_implicit_contact/implicit_contact.hpp"

#include "chapters/04_friction/surface_turn.hpp"
#include "chapters/07_implicit_contact/anderson_mixing.hpp"
#include "chapters/07_implicit_contact/pressing_mass.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace enduring {
namespace {

/// What counts as a momentum at all: what gravity gives to all bodies in a step, or if that is more, what
/// the rounding of their coordinates does [sqrt(kg) m/s].
double least_speed(const World& world, double dt)
{
    double mass = 0, largest = 0;
    for (const auto& body : world.bodies)
        if (!body->is_static()) {
            mass += body->mass();
            largest = std::max(largest, body->size());
        }
    return std::sqrt(mass) * std::max(scale_parts.least_answer * largest / dt, world.gravity.norm() * dt);
}

bool first_of_the_step(const Contacts& contacts)
{
    return std::none_of(contacts.begin(), contacts.end(),
                        [](const Contact& contact) { return contact.answered(); });
}

}  // namespace

void tell_unconverged(const SolveRecord& record)
{
    if (record.turns_too_far)
        std::cerr << "step " << record.step + 1 << ": the impulses of " << record.pairs
                  << " pairs turn a body too far; they are answered safely\n";
    else if (!record.converged)
        std::cerr << "step " << record.step + 1 << ": the impulses of " << record.pairs
                  << " pairs are solved to a residual of " << record.residual << " only, after "
                  << record.rounds << " rounds and " << record.newton_steps << " steps of Newton's method\n";
}

namespace {

/// Residual up to which an answer is still better than one with limits of friction that are old.
constexpr double nearly_solved = 0.01;

/// How much further than without it an answer may turn a body [rad]. One that turns it by radians more may end
/// beside what pressed it: that solves the equation, too, with any energy.
constexpr double most_turned = 0.5;

std::vector<double> turns(const World& world, double dt)
{
    std::vector<double> of_body;
    for (const auto& body : world.bodies)
        of_body.push_back(dt * body->turning_speed());
    return of_body;
}

/// Whether an answer turns a body by radians more than `before`.
bool turns_too_far(const World& world, const std::vector<double>& before, double dt)
{
    const std::vector<double> now = turns(world, dt);
    for (std::size_t body = 0; body < now.size(); ++body)
        if (now[body] > before[body] + most_turned)
            return true;
    return false;
}

//! [answer_safely]
/// With the limits of friction that the last step's loads give. They may be wrong, but they are known: the
/// problem is convex, and its answer takes energy only.
void answer_safely(World& world, StepProblem& step, NewtonMatrix& matrix, double tolerance, double least)
{
    apply_impulses(world, step, Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(step.of_row.size())));
    look_again(world, step);
    step.problem.step.limit = FrictionLimit::lagged;
    for (std::size_t i = 0; i < step.of_row.size(); ++i)
        step.problem.rows[i].law.pressing = step.of_row[i]->load * step.problem.step.dt;
    const ProblemSolution solution = solve_convex(step.problem, matrix, unchanged(step.problem), tolerance,
                                                  least);
    apply_impulses(world, step, answers_to(step.problem, solution.change).impulses);
    look_again(world, step);
}
//! [answer_safely]

/// What comes to its answer at all comes near it in sixty rounds.
bool is_hopeless(const SolveRecord& record) { return record.rounds >= 60 && record.residual > nearly_solved; }

/// Residual to which the problem of a round is solved, where the bodies are at this one. Its normals stand still and
/// its soft masses are old, so a round seldom takes away more than this part of what is left.
double sharp_enough(double residual, double tolerance) { return std::max(0.1 * tolerance, 1e-3 * residual); }

}  // namespace

//! [answer_all_pairs]
void answer_all_pairs(World& world, Contacts& contacts, const ImplicitSettings& settings,
                      NewtonMatrix& matrix, double dt)
{
    const bool first = first_of_the_step(contacts);
    matrix.begin_response(first);
    const std::vector<double> before = turns(world, dt);
    StepProblem step = set_up(world, contacts, settings.stiffness, settings.friction, {settings.centre, dt},
                              first);
    if (first)
        apply_impulses(world, step, last_impulses(world, step));
    SolveRecord record{world.step, static_cast<int>(step.problem.rows.size())};
    const double least = least_speed(world, dt);
    AndersonMixing mixing;
    for (;; ++record.rounds) {
        look_again(world, step);
        record.residual = residual_of(step.problem, Eigen::VectorXd::Zero(step.problem.size), least);
        record.converged = record.residual <= settings.tolerance;
        if (record.converged && stiffen_where_pressed(world, step, settings.stiffness)) {
            mixing = {};
            continue;
        }
        const int steps_left = settings.most_newton_steps - matrix.solves();
        if (record.converged || steps_left <= 0 || is_hopeless(record))
            break;
        const ProblemSolution solution = solve(
            step.problem, matrix, sharp_enough(record.residual, settings.tolerance), least, steps_left);
        record.newton_steps += solution.newton_steps;
        apply_impulses(world, step, mixing.next(impulses_acting(step.problem), solution.impulses));
    }
    record.turns_too_far = turns_too_far(world, before, dt);
    record.converged = record.converged && !record.turns_too_far;
    if (record.residual > nearly_solved || record.turns_too_far)
        answer_safely(world, step, matrix, settings.tolerance, least);
    find_slip(step);
    for (Contact& contact : contacts)
        if (contact.waiting())
            contact.state = ContactState::answered;
    settings.record(record);
}
//! [answer_all_pairs]

//! [remember_pairs]
void remember_pairs(const World& world, Contacts& contacts, double dt)
{
    for (Contact& contact : contacts) {
        if (contact.held()) {  // its spring lets go: where the pair pushes again, it begins as a new one does
            contact.stiffness = 0;
            contact.stretch.setZero();
            continue;
        }
        contact.load = contact.impulse.norm() / dt;
        contact.stretch = contact.stiffness > 0 ? Vec3(contact.friction / (-contact.stiffness * dt))
                                                : Vec3(Vec3::Zero());
        contact.stretch = surface_turn(world, contact) * contact.stretch;
    }
}
//! [remember_pairs]

}  // namespace enduring
