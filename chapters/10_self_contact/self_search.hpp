#pragma once

#include "chapters/09_deep_contacts/deep_search.hpp"
#include "common/simulation/rest_neighbours.hpp"

namespace enduring {

/// Chapter 9's search, and the surfaces of bodies that meet themselves against themselves.
class SelfSearch final : public DeepSearch {
protected:
    void find_more(const World& world) override;
};

/// The pairs of features of one surface to look at, as collect_pairs() finds those of two: each once, and
/// none of neighbours. Of two edges the smaller comes first.
void collect_own_pairs(const FaceTree& tree, const RestNeighbours& neighbours, CandidatePairs& pairs);

}  // namespace enduring
