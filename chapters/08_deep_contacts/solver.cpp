#include "chapters/08_deep_contacts/solver.hpp"

#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_deep_contacts/inside_pairs.hpp"
#include "chapters/08_deep_contacts/neighbours.hpp"
#include "chapters/08_deep_contacts/spring_compression.hpp"

#include <memory>
#include <utility>

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
Solver chapter08_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    const double keep = std::exchange(settings.stiffness.keep, 1);  // slack fades here, not there
    Solver solver = asking_neighbours(chapter07_solver(parameters, settings));
    solver.name = "chapter 8";
    const auto springs = std::make_shared<SpringCompressions>();
    solver.insert_before(
        "redefine vertices, ask the neighbours", "note compressions",
        [springs](World& world, Contacts& contacts, double) { springs->note(world, contacts); });
    solver.insert_before(
        "dismiss edges", "keep compressions",
        [springs](World& world, Contacts& contacts, double) { springs->keep(world, contacts); });
    solver.append(StepStage::refresh, "let out",
                  [keep](World&, Contacts& contacts, double dt) { fade_slack(contacts, keep, dt); });
    solver.append(StepStage::refresh, "find what is inside",
                  [inside = std::make_shared<InsidePairs>()](World& world, Contacts& contacts, double) {
                      inside->append_missing(world, contacts);
                  });
    return solver;
}
//! [solver]

Solver chapter08_solver(const ContactParameters& parameters) { return chapter08_solver(parameters, {}); }

}  // namespace enduring
