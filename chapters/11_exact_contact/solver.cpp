#include "chapters/11_exact_contact/solver.hpp"

#include "chapters/10_self_contact/solver.hpp"

#include <utility>

namespace enduring {

//! [solver]
Solver chapter11_solver(const ContactParameters& parameters, ImplicitSettings settings,
                        ExactStepSettings exact)
{
    Solver solver = chapter10_solver(parameters, std::move(settings));
    solver.name = "chapter 11";
    solver.exact = true;
    solver.has_surface_laws = false;  // the passes remember Coulomb's friction alone
    solver.wrap(
        "solve contacts", "solve contacts in passes",
        [exact = std::move(exact)](const Pass::Function& solve, World& world, Contacts& contacts, double dt) {
            solve_in_passes(solve, world, contacts, dt, exact);
        });
    solver.append(StepStage::finish, "leave force to load",
                  [](World& world, Contacts& contacts, double) { leave_force_to_load(world, contacts); });
    return solver;
}
//! [solver]

Solver chapter11_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    return chapter11_solver(parameters, std::move(settings), {});
}

Solver chapter11_solver(const ContactParameters& parameters) { return chapter11_solver(parameters, {}, {}); }

}  // namespace enduring
