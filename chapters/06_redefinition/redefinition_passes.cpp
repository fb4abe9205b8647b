#include "chapters/06_redefinition/redefinition_passes.hpp"

#include "chapters/06_redefinition/edge_edge_dismissal.hpp"
#include "chapters/06_redefinition/edge_pairs_of_redefinition.hpp"
#include "chapters/06_redefinition/new_pairs.hpp"
#include "chapters/06_redefinition/resolution.hpp"

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

}  // namespace enduring
