#include "chapters/11_exact_contact/solver.hpp"

#include "chapters/08_speculative_contacts/solver.hpp"

#include <utility>

namespace enduring {
namespace {

/// How far a pair may still be slack, as a part of what its force presses it, and be taken for one that began outside. A
/// hundredth: its offset fades for longer. A hundred times: a pair that began deep is pushed out at once.
constexpr double nearly_faded = 0.01;
/// The part of the missing offset that a step puts in. All of it would be the method of multipliers; but a step changes velocities and
/// so depths only one step later, and a stack begins to sway. Ten times: so it does at h = 100. A tenth: it is pressed in for
/// minutes, not for seconds.
constexpr double remembered_part = 0.01;

}  // namespace

//! [remember_forces]
void remember_forces(Contacts& contacts, double keep, double dt)
{
    for (Contact& contact : contacts) {
        if (contact.held() || contact.stiffness == 0)
            continue;
        const double pressed = contact.impulse.norm() / (contact.stiffness * dt);
        if (contact.rest_offset >= -nearly_faded * pressed)
            contact.rest_offset = (contact.rest_offset + remembered_part * (pressed - contact.rest_offset)) /
                                  keep;
    }
}
//! [remember_forces]

Solver chapter11_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    const double keep = settings.stiffness.keep;
    Solver solver = chapter08_solver(parameters, std::move(settings));
    solver.name = "chapter 11";
    solver.append(StepStage::finish, "remember forces",
                  [keep](World&, Contacts& contacts, double dt) { remember_forces(contacts, keep, dt); });
    return solver;
}

Solver chapter11_solver(const ContactParameters& parameters) { return chapter11_solver(parameters, {}); }

}  // namespace enduring
