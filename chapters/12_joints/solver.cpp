#include "chapters/12_joints/solver.hpp"

#include "chapters/10_self_contact/solver.hpp"
#include "chapters/12_joints/joint_rows.hpp"
#include "chapters/12_joints/joint_step.hpp"

#include <memory>
#include <utility>

namespace enduring {
namespace {

/// What the search has found of bodies that a joint holds together is left out, at the start of a step and after each answer.
void leave_out_joined_pairs(Solver& solver)
{
    const auto drop = [](World& world, Contacts& contacts, double) { drop_joined_pairs(world, contacts); };
    solver.append(StepStage::refresh, "leave out joined pairs", drop);
    solver.append(StepStage::detect, "leave out joined pairs brought inside", drop);
}

}  // namespace

//! [solver]
Solver chapter12_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    settings.elements = joint_elements();
    Solver solver = chapter10_solver(parameters, std::move(settings));
    solver.name = "chapter 12";
    solver.has_joints = true;
    leave_out_joined_pairs(solver);
    const auto before = std::make_shared<std::vector<JointRates>>();
    solver.insert_before(solver.passes(StepStage::refresh).front().name, "note joints",
                         [before](World& world, Contacts&, double) { *before = joint_rates(world); });
    solver.append(StepStage::finish, "book joints",
                  [before](World& world, Contacts&, double dt) { book_joints(world, *before, dt); });
    solver.append(StepStage::settle, "end joints",
                  [](World& world, Contacts&, double) { end_joints(world); });
    return solver;
}
//! [solver]

Solver chapter12_solver(const ContactParameters& parameters) { return chapter12_solver(parameters, {}); }

}  // namespace enduring
