#pragma once

#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "common/simulation/rest_neighbours.hpp"

namespace enduring {

/// The search of the chapters before, and the surfaces of bodies that meet themselves against themselves.
class SelfDetection final : public CrossingDetection {
protected:
    void find_more(const World& world) override;
};

/// The pairs of features of one surface to look at, as collect_pairs() finds those of two: each once, and none
/// of neighbours. Of two edges the smaller comes first.
void collect_own_pairs(const FaceTree& tree, const RestNeighbours& neighbours, CandidatePairs& pairs);

}  // namespace enduring
