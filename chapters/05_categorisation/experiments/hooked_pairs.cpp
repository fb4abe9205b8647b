#include "chapters/05_categorisation/experiments/hooked_pairs.hpp"

#include "chapters/05_categorisation/solver.hpp"

#include <algorithm>

namespace enduring::chapter05 {
namespace {

void treat(Contacts& contacts, HookedPairs treatment)
{
    const auto hooked = [](const Contact& contact) { return contact.category == ContactCategory::hooked; };
    if (treatment == HookedPairs::held)
        for (Contact& contact : contacts)
            if (!contact.answered())
                contact.hold(hooked(contact));
    if (treatment == HookedPairs::dropped)
        contacts.erase(std::remove_if(contacts.begin(), contacts.end(), hooked), contacts.end());
}

}  // namespace

Solver solver_that(HookedPairs treatment, EdgeRule rule, const ContactParameters& parameters)
{
    Solver solver = chapter05_solver(parameters);
    solver.name = "chapter 5, hooked pairs treated";
    solver.replace("categorise", "categorise", [rule, treatment](World& world, Contacts& contacts, double) {
        label_contacts(world, contacts, rule);
        treat(contacts, treatment);
    });
    solver.replace("categorise new", "categorise new",
                   [rule, treatment](World& world, Contacts& contacts, double) {
                       label_new_contacts(world, contacts, rule);
                       treat(contacts, treatment);
                   });
    return solver;
}

}  // namespace enduring::chapter05
