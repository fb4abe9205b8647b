#include "chapters/07_implicit_contact/solver.hpp"

#include "chapters/06_redefinition/solver.hpp"

namespace enduring {

//! [solver]
Solver chapter07_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    settings.friction = coefficients_of(parameters.friction);
    ContactParameters frictionless = parameters;
    frictionless.friction = NoFriction{};
    Solver solver = chapter06_solver(frictionless);
    solver.name = "chapter 7";
    solver.replace("impulses", "answer all pairs", [settings](World& world, Contacts& contacts, double dt) {
        answer_all_pairs(world, contacts, settings, dt);
    });
    solver.append(StepStage::finish, "remember pairs",
                  [](World& world, Contacts& contacts, double dt) { remember_pairs(world, contacts, dt); });
    return solver;
}
//! [solver]

Solver chapter07_solver(const ContactParameters& parameters) { return chapter07_solver(parameters, {}); }

}  // namespace enduring
