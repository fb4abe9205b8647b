#include "chapters/06_redefinition/experiments/slide_without.hpp"

#include "chapters/06_redefinition/solver.hpp"

namespace enduring::chapter06 {
namespace {

void drop_edge_pairs(World&, Contacts& contacts, double)
{
    std::erase_if(contacts, [](const Contact& contact) { return contact.kind == ContactKind::edge_edge; });
}

void push_hooked(World&, Contacts& contacts, double)
{
    for (Contact& contact : contacts)
        if (contact.kind == ContactKind::vertex_face && contact.category == ContactCategory::hooked &&
            contact.held())
            contact.hold(false);
}

}  // namespace

std::string name_of(Omission omission)
{
    switch (omission) {
        case Omission::none: return "nothing";
        case Omission::edges_behind_exits: return "edge pairs of vertices that leave";
        case Omission::edge_handover: return "edge pairs of redefinitions and exits";
        case Omission::all_edge_pairs: return "all edge pairs";
        case Omission::hooked_are_held: break;
    }
    return "holding hooked pairs";
}

Solver solver_without(Omission omission, const ContactParameters& parameters)
{
    Solver solver = chapter06_solver(parameters);
    switch (omission) {
        case Omission::none: break;
        case Omission::all_edge_pairs:
            solver.append(StepStage::detect, "drop edge pairs", drop_edge_pairs);
            [[fallthrough]];
        case Omission::edge_handover: solver.remove("edge pairs of redefinitions"); [[fallthrough]];
        case Omission::edges_behind_exits: solver.remove("edge pairs of exits"); break;
        case Omission::hooked_are_held:
            solver.append(StepStage::refresh, "push hooked", push_hooked);
            solver.append(StepStage::detect, "push new hooked", push_hooked);
    }
    return solver;
}

}  // namespace enduring::chapter06
