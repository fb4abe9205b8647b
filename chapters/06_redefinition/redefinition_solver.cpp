#include "redefinition_solver.hpp"

#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/03_penalty_impulses/penalty_contact.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "edge_edge_dismissal.hpp"
#include "edge_pairs_of_redefinition.hpp"
#include "new_pairs.hpp"
#include "resolution.hpp"

namespace enduring {

//! [follow_enduring]
void follow_enduring_pairs(const World& world, Contacts& contacts)
{
    Redefinitions redefinitions;
    drop_resolved(contacts);
    redefine_enduring_vertices(world, contacts, redefinitions);
    dismiss_enduring_edges(world, contacts);
    append_edge_pairs(world, redefinitions, 0, contacts);
    drop_resolved(contacts);
}
//! [follow_enduring]

//! [detect_new]
void detect_new_pairs(const World& world, const CrossingDetection& detection, Contacts& contacts)
{
    Redefinitions redefinitions;
    const std::size_t first_new = contacts.size();
    detection.append_entries(world, contacts);
    admit_new_pairs(world, contacts, first_new, redefinitions);
    append_edge_pairs(world, redefinitions, 1, contacts);
}
//! [detect_new]

//! [resolve]
void resolve_pairs_that_left(const World& world, const CrossingDetection& detection, Contacts& contacts)
{
    Redefinitions redefinitions;
    resolve_vertices_that_left(world, detection, contacts, redefinitions);
    append_edge_pairs(world, redefinitions, 1, contacts);
    resolve_edges_that_left(world, detection, contacts);
}
//! [resolve]

//! [solver]
Solver chapter06_solver(const ContactParameters& parameters)
{
    const auto detection = std::make_shared<CrossingDetection>();
    Solver solver = chapter01_solver(parameters);
    solver.name = "chapter 6";
    solver.enduring.push_back({"follow pairs", [](World& world, Contacts& contacts, double) {
        follow_enduring_pairs(world, contacts);
    }});
    solver.detect.push_back({"broad phase", [detection](World& world, Contacts&, double) {
        detection->find_candidates(world);
    }});
    solver.detect.push_back({"new pairs", [detection](World& world, Contacts& contacts, double) {
        detect_new_pairs(world, *detection, contacts);
    }});
    solver.respond.push_back({"impulses", [parameters](World& world, Contacts& contacts, double dt) {
        push_pairs_apart(world, contacts, parameters.method, parameters.stiffness, dt);
    }});
    add_friction(solver, parameters.friction);
    solver.finish.push_back({"resolve pairs", [detection](World& world, Contacts& contacts, double) {
        resolve_pairs_that_left(world, *detection, contacts);
    }});
    return solver;
}
//! [solver]

}  // namespace enduring
