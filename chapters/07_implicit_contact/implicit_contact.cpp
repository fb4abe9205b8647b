#include "chapters/07_implicit_contact/implicit_contact.hpp"

#include "chapters/04_friction/surface_turn.hpp"
#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace enduring {
namespace {

/// Residual below which Newton's method on the real problem, without a safeguard, may be trusted.
constexpr double near_the_answer = 1e-3;

/// Whether the unguarded step may be taken: near the answer, and as long as it at least halves the residual.
/// Where it does not, as with masses that are only nearly right, not again in this solve.
class Trust {
public:
    bool in(double residual)
    {
        if (was_near_ && residual > 0.5 * before_)
            lost_ = true;
        before_ = residual;
        was_near_ = !lost_ && residual < near_the_answer;
        return was_near_;
    }

private:
    double before_ = 0;
    bool was_near_ = false, lost_ = false;
};

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

//! [next_change]
/// Far away the convex problem leads on safely, with limits of friction from the last round. Near the answer
/// Newton's method on the real one doubles its digits.
Eigen::VectorXd next_change(ContactProblem& problem, NewtonMatrix& matrix, bool is_near, double tolerance,
                            double least, SolveRecord& record)
{
    if (is_near) {
        ++record.newton_steps;
        return newton_step(problem, matrix);
    }
    problem.step.limit = FrictionLimit::lagged;
    const ProblemSolution solution = solve(problem, matrix, 0.1 * tolerance, least);
    record.newton_steps += solution.newton_steps;
    return solution.change;
}
//! [next_change]

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
        apply_last_impulses(world, step);
    SolveRecord record{world.step, static_cast<int>(step.problem.rows.size())};
    const double least = least_speed(world, dt);
    Trust trust;
    NewtonMatrix matrix;
    for (;; ++record.rounds) {
        look_again(world, step);
        step.problem.step.limit = FrictionLimit::coupled;
        record.residual = residual_of(step.problem, Eigen::VectorXd::Zero(step.problem.size), least);
        record.converged = record.residual <= settings.tolerance;
        if (record.converged || record.rounds == settings.most_rounds)
            break;
        const Eigen::VectorXd change = next_change(step.problem, matrix, trust.in(record.residual),
                                                   settings.tolerance, least, record);
        apply_change(world, step, change);
    }
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
