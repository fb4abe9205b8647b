#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

//! [same_place]
/// Where corners of two bodies lie exactly on each other, rounding decides which features are nearest, and
/// one place may get several pairs: of the upper corner with the lower side, and of the lower corner with the
/// upper side. One of them is enough, the first by its key, so the pairs at rest do not come and go.
/// @param first  from this one on in the list pairs may go; of those before all stay
void keep_one_at_each_place(const World& world, Contacts& contacts, std::size_t first = 0);
//! [same_place]

}  // namespace enduring
