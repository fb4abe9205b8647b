#include "chapters/08_deep_contacts/solver.hpp"

#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_deep_contacts/neighbours.hpp"

namespace enduring {

//! [asking_neighbours]
Solver asking_neighbours(Solver solver)
{
    solver.insert_before(
        "admit new pairs", "ask the neighbours",
        [](World& world, Contacts& contacts, double) { vouch_for_new_pairs(world, contacts); });
    const Pass::Function redefine = solver.pass("redefine vertices").run;
    solver.replace("redefine vertices", "redefine vertices, ask the neighbours",
                   [redefine](World& world, Contacts& contacts, double dt) {
                       const auto vouched = take_vouched_pairs(world, contacts);
                       redefine(world, contacts, dt);
                       follow_vouched_pairs(world, vouched, contacts);
                   });
    return solver;
}
//! [asking_neighbours]

//! [solver]
Solver chapter08_solver(const ContactParameters& parameters)
{
    Solver solver = asking_neighbours(chapter07_solver(parameters));
    solver.name = "chapter 8";
    return solver;
}
//! [solver]

}  // namespace enduring
