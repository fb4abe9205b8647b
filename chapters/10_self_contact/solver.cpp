#include "chapters/10_self_contact/solver.hpp"

#include "chapters/09_deep_contacts/solver.hpp"
#include "chapters/10_self_contact/self_search.hpp"

#include <memory>
#include <utility>

namespace enduring {

//! [solver]
Solver chapter10_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    Solver solver = chapter09_solver(parameters, std::move(settings), std::make_shared<SelfSearch>());
    solver.name = "chapter 10";
    return solver;
}
//! [solver]

Solver chapter10_solver(const ContactParameters& parameters) { return chapter10_solver(parameters, {}); }

}  // namespace enduring
