#pragma once

#include "chapters/08_contact_by_distance/near_pairs.hpp"

namespace enduring {

/// What chapter 2's query finds on the way to the present end of the step.
struct Crossings {
    Contacts brought;      ///< pairs that are new
    Contacts let_through;  ///< pairs that are known, and whose features cross all the same

    bool none() const { return brought.empty() && let_through.empty(); }
};

//! [find_crossings]
/// Asks the query about all candidates.
///
/// Of two bodies that keep their shape only the first impact counts: the first crossing with all at the same
/// moment, and what follows within a fiftieth of the step and pushes the same way. An answer to it changes
/// the motion of all their points, so later crossings are consequences. So may be one that pushes another
/// way, however soon it follows: its plane and that of the first would be a wedge, where one of them may not
/// act at all. A query after the answer tells. Of others the first of each vertex and each edge counts. A
/// known pair may cross on its straight path if it is on its own side at both ends of the step: what turns
/// goes in arcs. Where nothing else crosses, no edge of its features may pass through the other body at the
/// end.
Crossings find_crossings(const World& world, const CandidateSearch& search, const Nearness& nearness,
                         const Contacts& known);
//! [find_crossings]

/// Whether a pair that has crossed on its way is on its own side at both ends of the step, and no edge of its
/// features passes through the other body at the end.
bool ends_well(const World& world, const Contact& pair);

}  // namespace enduring
