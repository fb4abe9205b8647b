#pragma once

#include "chapters/08_contact_by_distance/near_pairs.hpp"

#include <vector>

namespace enduring {

/// Two bodies each whose surfaces for contact cross at the start of the step, or of which one lies wholly in
/// the other, ascending.
std::vector<TwoBodies> bodies_inside_each_other(const World& world);

}  // namespace enduring
