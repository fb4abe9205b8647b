#include "chapters/08_speculative_contacts/solver.hpp"

#include "chapters/08_speculative_contacts/contact_memory.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/natural_units.hpp"

#include <algorithm>
#include <utility>

namespace enduring {

//! [renew]
void renew_pairs(ContactSearch& search, const World& world, double dt, Contacts& contacts,
                 const std::function<void(Contacts&)>& find_more)
{
    Contacts found = search.find(world, contacts, dt);
    find_more(found);
    remember(world, contacts, found);
    contacts = std::move(found);
}
//! [renew]

//! [append]
void append_pairs_brought_inside(ContactSearch& search, const World& world, double dt, Contacts& contacts)
{
    if (!search.has_moved(world))
        return;
    const KnownPairs known(contacts);
    Contacts more = search.find(world, contacts, dt);
    std::erase_if(more, [&](const Contact& contact) { return known.contain(contact); });
    const bool any_inside = std::any_of(more.begin(), more.end(), [&](const Contact& contact) {
        return contact_geometry(world, contact, 1).depth <
               -scale_parts.wanted_depth * natural_length(world, contact);
    });
    if (any_inside)  // all of them: the next answer may bring in what is near
        contacts.insert(contacts.end(), more.begin(), more.end());
}
//! [append]

//! [solver]
Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        const std::shared_ptr<ContactSearch>& search)
{
    settings.stiffness.k_dt2_over_m *= search_parts.stiffer;
    Solver solver;
    solver.name = "chapter 8";
    solver.can_resume = true;
    solver.append(StepStage::refresh, "find pairs", [search](World& world, Contacts& contacts, double dt) {
        renew_pairs(*search, world, dt, contacts);
    });
    solver.append(StepStage::detect, "find pairs brought inside",
                  [search](World& world, Contacts& contacts, double dt) {
                      append_pairs_brought_inside(*search, world, dt, contacts);
                  });
    add_solve(solver, parameters, std::move(settings));
    return solver;
}
//! [solver]

Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    return chapter08_solver(parameters, std::move(settings), std::make_shared<ContactSearch>());
}

Solver chapter08_solver(const ContactParameters& parameters) { return chapter08_solver(parameters, {}); }

}  // namespace enduring
