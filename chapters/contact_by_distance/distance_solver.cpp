#include "chapters/contact_by_distance/distance_solver.hpp"

#include "chapters/08_speculative_contacts/contact_memory.hpp"
#include "chapters/contact_by_distance/distance_parts.hpp"
#include "chapters/contact_by_distance/distance_search.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace enduring {
namespace {

/// What a pair keeps turns with its features.
void turn_normals(World& world, Contacts& contacts, double)
{
    for (Contact& contact : contacts)
        if (!contact.normal_t0.isZero(0))
            contact.normal_t0 = contact_geometry(world, contact, 1).normal;
}

}  // namespace

//! [solver]
Solver distance_solver(const ContactParameters& parameters, ImplicitSettings settings, bool own_surfaces)
{
    const auto search = std::make_shared<DistanceSearch>(own_surfaces);
    settings.stiffness.k_dt2_over_m *= distance_parts.stiffer;
    Solver solver;
    solver.name = "contact by distance";
    solver.append(StepStage::refresh, "find pairs", [search](World& world, Contacts& contacts, double dt) {
        Contacts found = search->find(world, dt);
        remember(world, contacts, found);
        contacts = std::move(found);
    });
    solver.append(
        StepStage::detect, "let nothing cross", [search](World& world, Contacts& contacts, double dt) {
            if (std::none_of(contacts.begin(), contacts.end(), [](const Contact& c) { return c.waiting(); }))
                search->check(world, contacts, dt);
        });
    add_solve(solver, parameters, std::move(settings));
    solver.append(StepStage::respond, "count answers",
                  [search](World&, Contacts&, double) { search->count_answer(); });
    solver.append(StepStage::finish, "turn normals", turn_normals);
    solver.insert_before("restitution", "bring back",
                         [search](World& world, Contacts&, double) { search->bring_back(world); });
    return solver;
}
//! [solver]

}  // namespace enduring
