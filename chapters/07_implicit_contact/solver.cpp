#include "chapters/07_implicit_contact/solver.hpp"

#include "chapters/06_redefinition/solver.hpp"

namespace enduring {
namespace {

void take_coefficients(const FrictionParameters& friction, ImplicitSettings& settings)
{
    std::visit(
        [&](const auto& model) {
            if constexpr (requires { model.mu_s; })
                settings.friction = {model.mu_s, model.mu_d};
        },
        friction);
}

}  // namespace

//! [solver]
Solver chapter07_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    take_coefficients(parameters.friction, settings);
    ContactParameters frictionless = parameters;
    frictionless.friction = NoFriction{};
    Solver solver = chapter06_solver(frictionless);
    solver.name = "chapter 7";
    solver.replace("impulses", {"answer all pairs", [settings](World& world, Contacts& contacts, double dt) {
                                    answer_all_pairs(world, contacts, settings, dt);
                                }});
    solver.append(StepStage::finish, {"remember pairs", [](World& world, Contacts& contacts, double dt) {
                                          remember_pairs(world, contacts, dt);
                                      }});
    return solver;
}
//! [solver]

Solver chapter07_solver(const ContactParameters& parameters) { return chapter07_solver(parameters, {}); }

}  // namespace enduring
