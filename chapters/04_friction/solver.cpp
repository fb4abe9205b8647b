#include "chapters/04_friction/solver.hpp"

#include "chapters/03_penalty_impulses/solver.hpp"
#include "chapters/04_friction/friction_contact.hpp"

namespace enduring {

//! [solver]
Solver chapter04_solver(const ContactParameters& parameters)
{
    Solver solver = chapter03_solver(parameters);
    solver.name = "chapter 4";
    add_friction(solver, parameters.friction);
    return solver;
}
//! [solver]

}  // namespace enduring
