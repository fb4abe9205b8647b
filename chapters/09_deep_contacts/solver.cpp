#include "chapters/09_deep_contacts/solver.hpp"

#include "chapters/07_implicit_contact/step_problem.hpp"
#include "chapters/08_speculative_contacts/solver.hpp"
#include "chapters/09_deep_contacts/inside_pairs.hpp"
#include "common/simulation/natural_units.hpp"

#include <algorithm>
#include <utility>

namespace enduring {

//! [solver]
Solver chapter09_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        const std::shared_ptr<ContactSearch>& search)
{
    const double keep = std::exchange(settings.stiffness.keep, 1);  // rest offsets fade here, not there
    settings.stiffness.rubbing_offset = 100;                        // what separates from inside does not rub
    const auto inside = std::make_shared<InsidePairs>();
    Solver solver = chapter08_solver(parameters, settings, search);
    solver.name = "chapter 9";
    solver.insert_before("find pairs", "trace overlaps",
                         [inside](World& world, Contacts&, double) { inside->trace(world); });
    solver.replace("find pairs", "find pairs", [search, inside](World& world, Contacts& contacts, double dt) {
        renew_pairs(*search, world, dt, contacts,
                    [&](Contacts& found) { inside->append_pairs(world, found); });
    });
    solver.append(
        StepStage::refresh, "fade rest offsets",
        [inside, keep, speed = parameters.max_depenetration_velocity](World& world, Contacts& contacts,
                                                                      double dt) {
            const double most = max_load(world, dt);
            fade_rest_offset(contacts, keep, [&](const Contact& contact) {
                // What pushes more than others can bring upon it does not move out, and is not wound up. Its load is
                // that of impulses that moved something; a push that another one cancels is seen in its spring.
                const double compressed = contact.rest_offset - depth_at_start(world, contact) -
                                          scale_parts.trembling * natural_length(world, contact);
                return std::max(contact.load, contact.stiffness * compressed) > most
                           ? 0
                           : max_depenetration_velocity(world, contact, speed, dt) * dt *
                                 inside->part_along_direction(world, contact);
            });
        });
    return solver;
}
//! [solver]

Solver chapter09_solver(const ContactParameters& parameters) { return chapter09_solver(parameters, {}); }

}  // namespace enduring
