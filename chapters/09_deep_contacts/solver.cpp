#include "chapters/09_deep_contacts/solver.hpp"

#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/07_implicit_contact/step_problem.hpp"
#include "chapters/09_deep_contacts/neighbours.hpp"
#include "chapters/09_deep_contacts/self_detection.hpp"
#include "chapters/09_deep_contacts/spring_compression.hpp"

#include <memory>
#include <utility>

namespace enduring {

//! [asking_neighbours]
Solver asking_neighbours(Solver solver)
{
    solver.insert_before(
        "admit new pairs", "ask the neighbours",
        [](World& world, Contacts& contacts, double) { vouch_for_new_pairs(world, contacts); });
    solver.wrap("redefine vertices", "redefine vertices, ask the neighbours",
                [](const Pass::Function& redefine, World& world, Contacts& contacts, double dt) {
                    const auto vouched = take_vouched_pairs(world, contacts);
                    redefine(world, contacts, dt);
                    follow_vouched_pairs(world, vouched, contacts);
                });
    return solver;
}
//! [asking_neighbours]

//! [solver]
Solver chapter09_solver(const ContactParameters& parameters, ImplicitSettings settings, WaysOut ways)
{
    const double keep = std::exchange(settings.stiffness.keep, 1);  // slack fades here, not there
    settings.stiffness.rubbing_slack = 100;                         // what is let out does not rub
    Solver solver =
        asking_neighbours(chapter07_solver(parameters, settings, std::make_unique<SelfDetection>()));
    solver.name = "chapter 9";
    const auto springs = std::make_shared<SpringCompressions>();
    solver.insert_before(
        "redefine vertices, ask the neighbours", "note compressions",
        [springs](World& world, Contacts& contacts, double) { springs->note(world, contacts); });
    solver.insert_before(
        "dismiss edges", "keep compressions",
        [springs](World& world, Contacts& contacts, double) { springs->keep(world, contacts); });
    const auto inside = std::make_shared<InsidePairs>(std::move(ways));
    solver.append(
        StepStage::refresh, "find what is inside",
        [inside](World& world, Contacts& contacts, double) { inside->append_missing(world, contacts); });
    solver.append(
        StepStage::refresh, "let out",
        [inside, keep, speed = parameters.leaving_speed](World& world, Contacts& contacts, double dt) {
            const double most = most_load(world, dt);
            fade_slack(contacts, keep, [&](const Contact& contact) {
                // what carries more than others can bring upon it does not move out, and is not wound up
                return contact.load > most ? 0
                                           : leaving_speed(world, contact, speed, dt) * dt *
                                                 inside->part_along_the_way(world, contact);
            });
        });
    return solver;
}
//! [solver]

Solver chapter09_solver(const ContactParameters& parameters) { return chapter09_solver(parameters, {}); }

}  // namespace enduring
