#include "chapters/09_deep_contacts/solver.hpp"

#include "chapters/08_contact_by_distance/solver.hpp"

#include <utility>

namespace enduring {

//! [solver]
Solver chapter09_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        const std::shared_ptr<DeepSearch>& search)
{
    Solver solver = chapter08_solver(parameters, std::move(settings), search);
    solver.name = "chapter 9";
    return solver;
}
//! [solver]

Solver chapter09_solver(const ContactParameters& parameters) { return chapter09_solver(parameters, {}); }

}  // namespace enduring
