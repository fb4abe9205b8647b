#include "chapters/07_implicit_contact/solver.hpp"

#include "chapters/06_redefinition/solver.hpp"
#include "chapters/07_implicit_contact/elastic_ends.hpp"
#include "chapters/07_implicit_contact/restitution.hpp"

#include <memory>
#include <string>

namespace enduring {

//! [solver]
Solver chapter07_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    settings.friction = coefficients_of(parameters.friction);
    if (parameters.wanted_depth)
        settings.stiffness.wanted_depth = parameters.wanted_depth;
    ContactParameters frictionless = parameters;
    frictionless.friction = NoFriction{};
    Solver solver = chapter06_solver(frictionless);
    solver.name = "chapter 7";
    solver.max_halvings = max_halvings;
    const std::string first = solver.passes(StepStage::refresh).front().name;
    solver.insert_before(first, "settle soft bodies",
                         [](World& world, Contacts&, double dt) { settle_soft_bodies(world, dt); });
    solver.replace("impulses", "solve contacts",
                   [settings, matrices = std::make_shared<IslandMatrices>()](World& world, Contacts& contacts,
                                                                             double dt) {
                       solve_contacts(world, contacts, settings, *matrices, dt);
                   });
    solver.finds_stiffness = true;
    solver.append(StepStage::finish, "remember pairs",
                  [](World& world, Contacts& contacts, double dt) { remember_pairs(world, contacts, dt); });
    solver.append(StepStage::settle, "restitution",
                  [friction = settings.friction](World& world, Contacts& contacts, double dt) {
                      restitute(world, contacts, friction, dt);
                  });
    return solver;
}
//! [solver]

Solver chapter07_solver(const ContactParameters& parameters) { return chapter07_solver(parameters, {}); }

}  // namespace enduring
