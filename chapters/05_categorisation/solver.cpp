#include "chapters/05_categorisation/solver.hpp"

#include "chapters/04_friction/solver.hpp"
#include "chapters/05_categorisation/category.hpp"

namespace enduring {

//! [solver]
Solver chapter05_solver(const ContactParameters& parameters)
{
    Solver solver = chapter04_solver(parameters);
    solver.name = "chapter 5";
    solver.refresh.push_back({"categorise", [](World& world, Contacts& contacts, double) {
        label_contacts(world, contacts);
    }});
    solver.detect.push_back({"categorise new", [](World& world, Contacts& contacts, double) {
        label_new_contacts(world, contacts);
    }});
    return solver;
}
//! [solver]

}  // namespace enduring
