#pragma once

#include "chapters/08_contact_by_distance/near_pairs.hpp"

namespace enduring {

/// Of what touches at the end of a step, whose pairs are wanted.
enum class EndsOf {
    new_bodies,   ///< of two bodies without any pair: without an answer, what rests falls through its ground
    new_features  ///< of each vertex without a pair with that body, and of each two edges
};

//! [pairs_at_the_end]
/// The pairs of what has none, and overlaps at the present end of the step, of the bodies' own surfaces: a
/// vertex over a face, and two edges. Their surfaces for contact are still apart, so no query sees them, and
/// they would press by both skins before they are found.
/// @param known  pairs of this step
Contacts pairs_at_the_end(const World& world, const CandidateSearch& search, const Nearness& nearness,
                          const Contacts& known, EndsOf wanted);
//! [pairs_at_the_end]

}  // namespace enduring
