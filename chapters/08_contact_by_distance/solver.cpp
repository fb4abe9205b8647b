#include "chapters/08_contact_by_distance/solver.hpp"

#include "chapters/08_contact_by_distance/contact_memory.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <utility>

namespace enduring {
namespace {

bool any_waiting(const Contacts& contacts)
{
    return std::any_of(contacts.begin(), contacts.end(), [](const Contact& c) { return c.waiting(); });
}

/// What a pair keeps turns with its features.
void turn_normals(World& world, Contacts& contacts, double)
{
    for (Contact& contact : contacts)
        if (!contact.normal_t0.isZero(0))
            contact.normal_t0 = contact_geometry(world, contact, 1).normal;
}

}  // namespace

//! [solver]
Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        const std::shared_ptr<DistanceSearch>& search)
{
    settings.stiffness.k_dt2_over_m *= distance_parts.stiffer;
    Solver solver;
    solver.name = "chapter 8";
    solver.can_resume = true;
    solver.has_frames = true;
    solver.max_responses = distance_parts.most_answers;
    solver.append(StepStage::refresh, "put skins",
                  [search](World& world, Contacts&, double dt) { search->begin(world, dt); });
    solver.append(StepStage::refresh, "find pairs", [search](World& world, Contacts& contacts, double dt) {
        Contacts found = search->find(world, dt);
        remember(world, contacts, found);
        contacts = std::move(found);
    });
    solver.append(StepStage::detect, "let nothing cross",
                  [search](World& world, Contacts& contacts, double dt) {
                      if (!any_waiting(contacts))
                          search->check(world, contacts, dt);
                  });
    add_solve(solver, parameters, std::move(settings));
    solver.append(StepStage::finish, "turn normals", turn_normals);
    solver.insert_before("restitution", "bring back",
                         [search](World& world, Contacts&, double) { search->bring_back(world); });
    return solver;
}
//! [solver]

Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    return chapter08_solver(parameters, std::move(settings), std::make_shared<DistanceSearch>());
}

Solver chapter08_solver(const ContactParameters& parameters) { return chapter08_solver(parameters, {}); }

}  // namespace enduring
