#include "chapters/05_categorisation/solver.hpp"

#include "chapters/04_friction/solver.hpp"
#include "chapters/05_categorisation/category.hpp"

namespace enduring {

//! [solver]
Solver chapter05_solver(const ContactParameters& parameters)
{
    Solver solver = chapter04_solver(parameters);
    solver.name = "chapter 5";
    solver.append(StepStage::refresh, "categorise",
                  [](World& world, Contacts& contacts, double) { label_contacts(world, contacts); });
    solver.append(StepStage::detect, "categorise new",
                  [](World& world, Contacts& contacts, double) { label_new_contacts(world, contacts); });
    return solver;
}
//! [solver]

}  // namespace enduring
