#include "chapters/07_implicit_contact/solver.hpp"

#include "chapters/06_redefinition/solver.hpp"
#include "chapters/07_implicit_contact/false_hooks.hpp"
#include "chapters/07_implicit_contact/plausible_depth.hpp"
#include "chapters/07_implicit_contact/rim_pairs.hpp"
#include "chapters/07_implicit_contact/touching_pairs.hpp"
#include "chapters/07_implicit_contact/valley_pairs.hpp"

#include <memory>
#include <utility>

namespace enduring {

namespace {

/// On which face each vertex-face pair of the list stands.
std::vector<int> faces_of_vertices(const Contacts& contacts)
{
    std::vector<int> faces;
    for (const Contact& contact : contacts)
        if (contact.kind == ContactKind::vertex_face)
            faces.push_back(contact.feature_b);
    return faces;
}

//! [births]
/// What lies on a surface at first is found, and what is hooked falsely pushes.
void find_and_label(Solver& solver)
{
    solver.insert_before("categorise new", "pairs that touch at first",
                         [](World& world, Contacts& contacts, double) {
                             if (world.step == 0)
                                 append_touching_pairs(world, contacts);
                         });
    solver.insert_before("admit new pairs", "ask the cone", [](World& world, Contacts& contacts, double) {
        admit_falsely_hooked(world, contacts);
    });
    solver.wrap("redefine vertices", "redefine vertices",
                [](const Pass::Function& redefine, World& world, Contacts& contacts, double dt) {
                    const Contacts falsely = take_falsely_hooked(world, contacts);
                    redefine(world, contacts, dt);
                    follow_by_cone(world, falsely, contacts);
                });
}
//! [births]

/// Edges that come with a vertex' new face may cross it on the body's far side.
void keep_plausible_edges(Solver& solver)
{
    const auto keep_plausible = [&](const std::string& edge_pairs, double tau) {
        solver.wrap(edge_pairs, edge_pairs,
                    [tau](const Pass::Function& append, World& world, Contacts& contacts, double dt) {
                        const std::size_t first = contacts.size();
                        append(world, contacts, dt);
                        drop_implausible(world, contacts, first, tau);
                    });
    };
    keep_plausible("edge pairs of redefinitions", 0);
    keep_plausible("edge pairs of entries", 1);
    keep_plausible("edge pairs of exits", 1);
}

//! [far]
/// A vertex may pass several faces in a step. Chapter 6 hands its pair on to a neighbour of its face, so it is asked
/// again until no pair moves; the edges that were passed on the way get their pairs in between.
void follow_over_many_faces(Solver& solver)
{
    solver.wrap("redefine vertices", "redefine vertices",
                [edge_pairs = solver.pass("edge pairs of redefinitions").run](
                    const Pass::Function& redefine, World& world, Contacts& contacts, double dt) {
                    constexpr int most_faces = 100;  // two faces may hand a pair to and fro
                    std::vector<int> before = faces_of_vertices(contacts);
                    redefine(world, contacts, dt);
                    for (int passed = 1; passed < most_faces; ++passed) {
                        std::vector<int> now = faces_of_vertices(contacts);
                        if (now == before)
                            break;
                        before = std::move(now);
                        edge_pairs(world, contacts, dt);
                        redefine(world, contacts, dt);
                    }
                });
}
//! [far]

//! [rims]
/// A pair that pushes goes on beyond the rim of its face, or the end of its edge, by as much as it may be deep.
void push_beyond_rims(Solver& solver, const StiffnessChoice& choice)
{
    solver.wrap("resolve vertices", "resolve vertices",
                [choice, rims = std::make_shared<RimPairs>()](const Pass::Function& resolve, World& world,
                                                              Contacts& contacts, double dt) {
                    const Contacts before = contacts;
                    resolve(world, contacts, dt);
                    rims->keep(world, before, choice, contacts);
                });
    solver.wrap("dismiss edges", "dismiss edges",
                [choice](const Pass::Function& dismiss, World& world, Contacts& contacts, double dt) {
                    const Contacts before = contacts;
                    dismiss(world, contacts, dt);
                    push_beyond_ends(world, before, choice, contacts);
                });
}
//! [rims]

//! [all_walls]
/// A vertex at the bottom of a valley has a pair with each wall; chapter 6 sees one of them.
void push_from_all_walls(Solver& solver)
{
    const auto valleys = std::make_shared<ValleyPairs>();
    solver.insert_before("redefine vertices", "set other walls aside",
                         [valleys](World&, Contacts& contacts, double) { valleys->set_aside(contacts); });
    solver.append(StepStage::refresh, "follow other walls",
                  [valleys](World& world, Contacts& contacts, double) { valleys->follow(world, contacts); });
    solver.append(StepStage::detect, "find other walls", [](World& world, Contacts& contacts, double) {
        drop_what_cannot_touch(world, contacts);
        append_pairs_with_other_walls(world, contacts);
    });
    solver.wrap("resolve vertices", "resolve vertices",
                [valleys](const Pass::Function& resolve, World& world, Contacts& contacts, double dt) {
                    valleys->set_aside(contacts);
                    resolve(world, contacts, dt);
                    valleys->put_back(contacts);
                });
}
//! [all_walls]

}  // namespace

//! [solver]
Solver chapter07_solver(const ContactParameters& parameters, ImplicitSettings settings)
{
    settings.friction = coefficients_of(parameters.friction);
    if (parameters.wanted_depth)
        settings.stiffness.wanted_depth = parameters.wanted_depth;
    ContactParameters frictionless = parameters;
    frictionless.friction = NoFriction{};
    Solver solver = chapter06_solver(frictionless);
    solver.name = "chapter 7";
    solver.most_turn = 0.5;
    solver.replace(
        "impulses", "answer all pairs",
        [settings, matrix = std::make_shared<NewtonMatrix>()](World& world, Contacts& contacts, double dt) {
            answer_all_pairs(world, contacts, settings, *matrix, dt);
        });
    solver.finds_stiffness = true;
    find_and_label(solver);
    keep_plausible_edges(solver);
    follow_over_many_faces(solver);
    push_beyond_rims(solver, settings.stiffness);
    push_from_all_walls(solver);
    solver.append(StepStage::finish, "remember pairs",
                  [](World& world, Contacts& contacts, double dt) { remember_pairs(world, contacts, dt); });
    return solver;
}
//! [solver]

Solver chapter07_solver(const ContactParameters& parameters) { return chapter07_solver(parameters, {}); }

}  // namespace enduring
