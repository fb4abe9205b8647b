#include "chapters/09_deep_contacts/solver.hpp"

#include "chapters/08_speculative_contacts/solver.hpp"
#include "chapters/09_deep_contacts/inside_pairs.hpp"

namespace enduring {

//! [solver]
Solver chapter09_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        const std::shared_ptr<ContactSearch>& search)
{
    const auto inside = std::make_shared<InsidePairs>();
    Solver solver = chapter08_solver(parameters, settings, search);
    solver.name = "chapter 9";
    solver.insert_before("find pairs", "trace overlaps",
                         [inside](World& world, Contacts&, double) { inside->trace(world); });
    solver.replace("find pairs", "find pairs", [search, inside](World& world, Contacts& contacts, double dt) {
        renew_pairs(*search, world, dt, contacts,
                    [&](Contacts& found) { inside->append_pairs(world, search_margin(world, dt), found); });
        for (Contact& contact : contacts)
            contact.outward = inside->part_along_direction(world, contact);
    });
    return solver;
}
//! [solver]

Solver chapter09_solver(const ContactParameters& parameters) { return chapter09_solver(parameters, {}); }

}  // namespace enduring
