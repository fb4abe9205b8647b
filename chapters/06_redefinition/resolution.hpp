#pragma once

#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/06_redefinition/vertex_face_redefinition.hpp"

namespace enduring {

/// The advanced resolution condition, thesis 6.2.1, decided once a step on the motion that
/// is about to be committed: on an earlier prediction a vertex may leave and then, pushed
/// by its neighbours, stay after all, and be lost inside.
///
/// For vertices the crossings of the step are followed in their order: an entry puts the vertex inside, a
/// crossing that leads out puts it outside, through whichever face. One that ends outside resolves the pair.
/// So does one that never came in: impulses have changed the motion in which its entry was seen. One that
/// left and came back gets a new pair at the new place.
///
/// @param search         after find_candidates for the last prediction
/// @param redefinitions  gets those that left through another face than their own
void resolve_vertices_that_left(const World& world, const CandidateSearch& search, Contacts& contacts,
                                Redefinitions& redefinitions);

/// For edges: a pair is resolved when one of its edges lies outside the other body at the end of the step:
/// neither end is a vertex in contact with that body, and no face of it is pierced.
void resolve_edges_that_left(const World& world, const CandidateSearch& search, Contacts& contacts);

/// Takes resolved contacts off the list.
void drop_resolved(Contacts& contacts);

}  // namespace enduring
