#include "chapters/08_speculative_contacts/solver.hpp"

#include "chapters/07_implicit_contact/elastic_ends.hpp"
#include "chapters/07_implicit_contact/restitution.hpp"
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
    settings.friction = coefficients_of(parameters.friction);
    if (parameters.wanted_depth)
        settings.stiffness.wanted_depth = parameters.wanted_depth;
    settings.stiffness.k_dt2_over_m *= search_parts.stiffer;
    Solver solver;
    solver.name = "chapter 8";
    solver.max_halvings = max_halvings;
    solver.finds_stiffness = true;
    solver.can_resume = true;
    solver.append(StepStage::refresh, "settle soft bodies",
                  [](World& world, Contacts&, double dt) { settle_soft_bodies(world, dt); });
    solver.append(StepStage::refresh, "find pairs", [search](World& world, Contacts& contacts, double dt) {
        renew_pairs(*search, world, dt, contacts);
    });
    solver.append(StepStage::detect, "find pairs brought inside",
                  [search](World& world, Contacts& contacts, double dt) {
                      append_pairs_brought_inside(*search, world, dt, contacts);
                  });
    solver.append(StepStage::respond, "solve contacts",
                  [settings, matrices = std::make_shared<IslandMatrices>()](World& world, Contacts& contacts,
                                                                            double dt) {
                      solve_contacts(world, contacts, settings, *matrices, dt);
                  });
    solver.append(StepStage::finish, "remember pairs",
                  [](World& world, Contacts& contacts, double dt) { remember_pairs(world, contacts, dt); });
    solver.append(StepStage::settle, "restitution",
                  [friction = settings.friction](World& world, Contacts& contacts, double dt) {
                      restitute(world, contacts, friction, dt);
                  });
    return solver;
}
//! [solver]

Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    return chapter08_solver(parameters, std::move(settings), std::make_shared<ContactSearch>());
}

Solver chapter08_solver(const ContactParameters& parameters) { return chapter08_solver(parameters, {}); }

}  // namespace enduring
