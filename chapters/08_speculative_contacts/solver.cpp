#include "chapters/08_speculative_contacts/solver.hpp"

#include "chapters/07_implicit_contact/solver.hpp"

#include <utility>

namespace enduring {

//! [solver]
Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    Solver solver = chapter07_solver(parameters, std::move(settings));
    solver.name = "chapter 8";
    return solver;
}
//! [solver]

Solver chapter08_solver(const ContactParameters& parameters) { return chapter08_solver(parameters, {}); }

}  // namespace enduring
