#include "chapters/07_implicit_contact/implicit_contact.hpp"

#include "chapters/04_friction/surface_turn.hpp"
#include "chapters/07_implicit_contact/anderson_mixing.hpp"
#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace enduring {
namespace {

/// What counts as a momentum at all: what gravity, or a thousandth of it,
/// gives to all bodies in a step [sqrt(kg) m/s].
double least_speed(const World& world, double dt)
{
    double mass = 0;
    for (const auto& body : world.bodies)
        mass += body->mass();
    return std::sqrt(mass) * std::max(0.01, world.gravity.norm()) * dt;
}

bool first_of_the_step(const Contacts& contacts)
{
    return std::none_of(contacts.begin(), contacts.end(),
                        [](const Contact& contact) { return contact.answered(); });
}

}  // namespace

void tell_unconverged(const SolveRecord& record)
{
    if (!record.converged)
        std::cerr << "step " << record.step + 1 << ": the impulses of " << record.pairs
                  << " pairs are solved to a residual of " << record.residual << " only, after "
                  << record.rounds << " rounds\n";
}

//! [answer_all_pairs]
void answer_all_pairs(World& world, Contacts& contacts, const ImplicitSettings& settings, double dt)
{
    const bool first = first_of_the_step(contacts);
    StepProblem step = set_up(world, contacts, settings.stiffness, settings.friction, {settings.centre, dt},
                              first);
    if (first)
        apply_impulses(world, step, last_impulses(world, step));
    SolveRecord record{world.step, static_cast<int>(step.problem.rows.size())};
    const double least = least_speed(world, dt);
    NewtonMatrix matrix;
    AndersonMixing mixing;
    for (;; ++record.rounds) {
        look_again(world, step);
        record.residual = residual_of(step.problem, Eigen::VectorXd::Zero(step.problem.size), least);
        record.converged = record.residual <= settings.tolerance;
        if (record.converged || record.rounds == settings.most_rounds)
            break;
        // A stiff pair makes much of a small error in the velocities, so they are found more sharply.
        const ProblemSolution solution = solve(step.problem, matrix, 1e-4 * settings.tolerance, least);
        record.newton_steps += solution.newton_steps;
        const Eigen::VectorXd after = impulses_after(step, solution.change);
        apply_impulses(world, step, mixing.next(impulses_acting(step), after));
    }
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
        if (!contact.held()) {
            contact.load = contact.impulse.norm() / dt;
            contact.stretch = contact.stiffness > 0 ? Vec3(contact.friction / (-contact.stiffness * dt))
                                                    : Vec3(Vec3::Zero());
        }
        contact.stretch = surface_turn(world, contact) * contact.stretch;
    }
}
//! [remember_pairs]

}  // namespace enduring
