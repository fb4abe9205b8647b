#pragma once

#include "chapters/06_redefinition/vertex_face_redefinition.hpp"

namespace enduring {

/// Looks through the pairs that a detection has just found and chapter
/// 5 has labelled, before their first impulse:
///   a vertex in the body already, or with    one pair is enough, the earliest
///     two entries, through a diagonal
///   hooked, two edges                        dropped: thesis 6.2.4 leaves them to the redefinitions
///   hooked, vertex and face                  handed on to a regular face, or held
///
/// @param first_new      index of the first pair the detection found; those before are not touched
/// @param redefinitions  gets the vertices that were handed on
void admit_new_pairs(const World& world, Contacts& contacts, std::size_t first_new,
                     Redefinitions& redefinitions);

}  // namespace enduring
