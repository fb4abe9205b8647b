#include "chapters/11_exact_contact/exact_step.hpp"

#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/natural_units.hpp"

#include <algorithm>
#include <iostream>
#include <vector>

namespace enduring {
namespace {

/// The part of a gap or a depth that a step keeps: what passes have left is taken away slowly, as chapter 7
/// lets out what is inside. None of it: each step takes away what the last one left, a step too late, and
/// stacks on soft springs sway more and more.
constexpr double kept_gap = 0.9;

/// of a pair's length [1]: a pair that should end a step deeper than this began inside, and keeps to the
/// speed at which it is let out, wherever its body is.
constexpr double still_let_out = 1e-4;

/// @param aim  the depth at which the step should end [m]
bool is_let_out(const World& world, const Contact& contact, double aim)
{
    return aim < -still_let_out * natural_length(world, contact);
}

bool pushes(const Contact& contact) { return !contact.held() && contact.spring.stiffness > 0; }

/// The force along the normal that a pair's rest offset holds: of the last pass, or of the last step [N].
double remembered_force(const Contact& contact, double dt)
{
    return contact.answered() ? contact.impulse.norm() / dt : contact.spring.load;
}

std::vector<double> remembered_forces(const Contacts& contacts, double dt)
{
    std::vector<double> forces(contacts.size());
    std::transform(contacts.begin(), contacts.end(), forces.begin(),
                   [dt](const Contact& contact) { return remembered_force(contact, dt); });
    return forces;
}

//! [begin_with_load]
/// Pairs that are answered for the first time in this step begin with the force of the last one, at the depth
/// that is left of it.
void begin_with_load(const World& world, Contacts& contacts)
{
    for (Contact& contact : contacts)
        if (contact.waiting() && pushes(contact)) {
            if (!is_let_out(world, contact, contact.spring.rest_offset))
                contact.spring.rest_offset *= kept_gap;
            contact.spring.rest_offset += contact.spring.load / contact.spring.stiffness;
        }
}
//! [begin_with_load]

//! [remember_force]
/// After a solve: the spring begins the next one pressed in and stretched by what it pushed.
/// @param held  the force that it began with in this one [N]
/// @return      how far the solve has moved it beyond that [m]
double remember_force(Contact& contact, double held, double dt)
{
    const double k = contact.spring.stiffness, force = contact.impulse.norm() / dt;
    const Vec3 stretch = contact.friction / (-k * dt);
    const double moved = std::max(std::abs(force - held) / k, (stretch - contact.spring.stretch).norm());
    const double aim = contact.spring.rest_offset - held / k;  // the depth at which the step should end
    contact.spring.rest_offset = aim + force / k;
    contact.spring.stretch = stretch;
    return moved;
}
//! [remember_force]

}  // namespace

void tell_unfinished_passes(const PassRecord& record)
{
    if (!record.reached)
        std::cerr << "step " << record.step + 1 << ": after " << record.passes
                  << " passes a spring is still moved by " << record.moved << " of its pair's length\n";
}

//! [solve_in_passes]
void solve_in_passes(const Pass::Function& solve, World& world, Contacts& contacts, double dt,
                     const ExactStepSettings& settings)
{
    const StepTrouble before = world.attempt.trouble;
    begin_with_load(world, contacts);
    PassRecord record{world.step};
    for (record.reached = false; !record.reached && record.passes < settings.max_passes; ++record.passes) {
        const std::vector<double> held = remembered_forces(contacts, dt);
        world.attempt.trouble = before;
        solve(world, contacts, dt);
        record.moved = 0;
        for (std::size_t i = 0; i < contacts.size(); ++i)
            if (pushes(contacts[i]))
                record.moved = std::max(record.moved, remember_force(contacts[i], held[i], dt) /
                                                          natural_length(world, contacts[i]));
        record.reached = record.moved <= settings.tolerance;
        if (world.attempt.may_be_halved && world.attempt.trouble != StepTrouble::none)
            return;
    }
    settings.record(record);
}
//! [solve_in_passes]

//! [leave_force_to_load]
void leave_force_to_load(World& world, Contacts& contacts)
{
    for (Contact& contact : contacts) {
        if (!pushes(contact))
            continue;
        const double aim = contact.spring.rest_offset - contact.spring.load / contact.spring.stiffness;
        contact.spring.rest_offset = contact.spring.load > 0 && !is_let_out(world, contact, aim)
                                         ? contact_geometry(world, contact, 1).depth
                                         : std::min(0.0, aim);
    }
    world.attempt.added_energy += spring_energy(contacts) - world.attempt.springs;
}
//! [leave_force_to_load]

}  // namespace enduring
