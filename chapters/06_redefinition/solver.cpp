#include "chapters/06_redefinition/solver.hpp"

#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/05_categorisation/solver.hpp"
#include "chapters/06_redefinition/edge_pairs.hpp"
#include "chapters/06_redefinition/new_pairs.hpp"
#include "chapters/06_redefinition/resolution.hpp"

#include <memory>

namespace enduring {
namespace {

/// What a pass hands to those behind it.
struct HandedOn {
    CrossingDetection detection;    ///< resolution looks at its candidates too
    std::size_t first_new = 0;      ///< index of the first pair that the last queries found
    Redefinitions redefinitions{};  ///< of the pass before; edge pairs follow them
};

void drop(World&, Contacts& contacts, double) { drop_resolved(contacts); }

/// @param tau  moment of the step at which the edges are looked at
Pass::Function edge_pairs_at(double tau, const std::shared_ptr<HandedOn>& step)
{
    return [step, tau](World& world, Contacts& contacts, double) {
        append_edge_pairs(world, step->redefinitions, tau, contacts);
    };
}

//! [follow_enduring]
void follow_enduring_pairs(Solver& solver, const std::shared_ptr<HandedOn>& step)
{
    solver.replace("resolve pairs", "drop resolved pairs", drop);
    solver.replace("categorise", "redefine vertices", [step](World& world, Contacts& contacts, double) {
        step->redefinitions.clear();
        redefine_enduring_vertices(world, contacts, step->redefinitions);
    });
    solver.append(StepStage::refresh, "dismiss edges",
                  [](World& world, Contacts& contacts, double) { dismiss_enduring_edges(world, contacts); });
    solver.append(StepStage::refresh, "edge pairs of redefinitions", edge_pairs_at(0, step));
    solver.append(StepStage::refresh, "drop dismissed pairs", drop);
}
//! [follow_enduring]

//! [detect_new]
void detect_new_pairs(Solver& solver, const std::shared_ptr<HandedOn>& step)
{
    solver.replace("broad phase", "broad phase",
                   [step](World& world, Contacts&, double) { step->detection.find_candidates(world); });
    solver.replace("queries", "queries", [step](World& world, Contacts& contacts, double) {
        step->first_new = contacts.size();
        step->detection.append_entries(world, contacts);
    });
    solver.append(StepStage::detect, "admit new pairs", [step](World& world, Contacts& contacts, double) {
        step->redefinitions.clear();
        admit_new_pairs(world, contacts, step->first_new, step->redefinitions);
    });
    solver.append(StepStage::detect, "edge pairs of entries", edge_pairs_at(1, step));
}
//! [detect_new]

//! [resolve]
void resolve_pairs_that_left(Solver& solver, const std::shared_ptr<HandedOn>& step)
{
    solver.append(StepStage::finish, "resolve vertices", [step](World& world, Contacts& contacts, double) {
        step->redefinitions.clear();
        resolve_vertices_that_left(world, step->detection, contacts, step->redefinitions);
    });
    solver.append(StepStage::finish, "edge pairs of exits", edge_pairs_at(1, step));
    solver.append(StepStage::finish, "resolve edges", [step](World& world, Contacts& contacts, double) {
        resolve_edges_that_left(world, step->detection, contacts);
    });
}
//! [resolve]

}  // namespace

//! [solver]
Solver chapter06_solver(const ContactParameters& parameters)
{
    const auto step = std::make_shared<HandedOn>();
    Solver solver = chapter05_solver(parameters);
    solver.name = "chapter 6";
    follow_enduring_pairs(solver, step);
    detect_new_pairs(solver, step);
    resolve_pairs_that_left(solver, step);
    return solver;
}
//! [solver]

}  // namespace enduring
