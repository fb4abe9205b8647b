#include "chapters/06_redefinition/experiments/slide_without.hpp"

#include "chapters/06_redefinition/edge_edge_dismissal.hpp"
#include "chapters/06_redefinition/resolution.hpp"
#include "chapters/06_redefinition/solver.hpp"

#include <algorithm>

namespace enduring::chapter06 {
namespace {

bool is_edge_pair(const Contact& contact) { return contact.kind == ContactKind::edge_edge; }

/// The pass, and after it no edge pairs but those there were before.
std::function<void(World&, Contacts&, double)> without_new_edges(std::function<void(World&, Contacts&, double)> pass)
{
    return [pass](World& world, Contacts& contacts, double dt) {
        const std::size_t before = contacts.size();
        pass(world, contacts, dt);
        const auto first_new = contacts.begin() + static_cast<std::ptrdiff_t>(std::min(before, contacts.size()));
        contacts.erase(std::remove_if(first_new, contacts.end(), is_edge_pair), contacts.end());
    };
}

void redefine_alone(World& world, Contacts& contacts, double)
{
    Redefinitions redefinitions;
    drop_resolved(contacts);
    redefine_enduring_vertices(world, contacts, redefinitions);
    dismiss_enduring_edges(world, contacts);
    drop_resolved(contacts);
}

void push_hooked(World&, Contacts& contacts, double)
{
    for (Contact& contact : contacts)
        if (contact.kind == ContactKind::vertex_face && contact.category == ContactCategory::hooked && contact.held())
            contact.hold(false);
}

Pass& pass_named(std::vector<Pass>& passes, const std::string& name)
{
    return *std::find_if(passes.begin(), passes.end(), [&](const Pass& pass) { return pass.name == name; });
}

}  // namespace

std::string name_of(Omission omission)
{
    switch (omission) {
    case Omission::none:
        return "nothing";
    case Omission::edges_behind_exits:
        return "edge pairs of vertices that leave";
    case Omission::edge_handover:
        return "edge pairs of redefinitions and exits";
    case Omission::all_edge_pairs:
        return "all edge pairs";
    case Omission::hooked_are_held:
        break;
    }
    return "holding hooked pairs";
}

Solver solver_without(Omission omission, const ContactParameters& parameters)
{
    Solver solver = chapter06_solver(parameters);
    Pass &follow = pass_named(solver.refresh, "follow pairs"), &detect = pass_named(solver.detect, "new pairs"),
         &resolve = pass_named(solver.finish, "resolve pairs");
    if (omission == Omission::edges_behind_exits || omission == Omission::edge_handover || omission == Omission::all_edge_pairs)
        resolve.run = without_new_edges(resolve.run);
    if (omission == Omission::edge_handover || omission == Omission::all_edge_pairs)
        follow.run = redefine_alone;
    if (omission == Omission::all_edge_pairs)
        detect.run = without_new_edges(detect.run);
    if (omission == Omission::hooked_are_held) {
        solver.refresh.push_back({"push hooked", push_hooked});
        solver.detect.push_back({"push hooked", push_hooked});
    }
    return solver;
}

}  // namespace enduring::chapter06
