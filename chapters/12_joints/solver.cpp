#include "chapters/12_joints/solver.hpp"

#include "chapters/10_self_contact/solver.hpp"
#include "chapters/12_joints/joint_rows.hpp"
#include "chapters/12_joints/joint_step.hpp"

#include <memory>
#include <utility>

namespace enduring {

//! [solver]
Solver chapter12_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    settings.elements = joint_elements();
    Solver solver = chapter10_solver(parameters, std::move(settings));
    solver.name = "chapter 12";
    solver.has_joints = true;
    const auto before = std::make_shared<std::vector<JointRates>>();
    solver.insert_before(solver.passes(StepStage::refresh).front().name, "note joints",
                         [before](World& world, Contacts&, double dt) { *before = joint_rates(world, dt); });
    solver.append(StepStage::finish, "book joints", [before](World& world, Contacts& contacts, double dt) {
        book_joints(world, contacts, *before, dt);
    });
    solver.append(StepStage::after_commit, "end joints",
                  [](World& world, Contacts&, double) { end_joints(world); });
    return solver;
}
//! [solver]

Solver chapter12_solver(const ContactParameters& parameters) { return chapter12_solver(parameters, {}); }

}  // namespace enduring
