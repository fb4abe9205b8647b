#include "chapters/07_implicit_contact/solver.hpp"

#include "chapters/06_redefinition/solver.hpp"

#include <utility>

namespace enduring {

//! [solver]
Solver chapter07_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    ContactParameters frictionless = parameters;
    frictionless.friction = NoFriction{};
    Solver solver = chapter06_solver(frictionless);
    solver.name = "chapter 7";
    solver.remove("impulses");
    add_solve(solver, parameters, std::move(settings));
    return solver;
}
//! [solver]

Solver chapter07_solver(const ContactParameters& parameters) { return chapter07_solver(parameters, {}); }

}  // namespace enduring
