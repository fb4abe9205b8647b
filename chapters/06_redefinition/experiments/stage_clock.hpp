#pragma once

#include "common/experiments/run/run.hpp"

#include <map>
#include <string>

namespace enduring::chapter06 {

/// What one pair of a kind takes in each stage of its handling [ns]; the mean over all pairs of all steps.
struct StageTimes {
    double resolve = 0, categorise = 0, redefine = 0, cpf = 0, dpf = 0, friction = 0;

    double without_impulse() const { return resolve + categorise + redefine + friction; }
    double with_cpf() const { return without_impulse() + cpf; }
    double with_dpf() const { return without_impulse() + dpf; }
};

struct PairTimes {
    StageTimes vertex_face, edge_edge;
    double pairs_per_step = 0;  ///< of both kinds
};

/// Runs a scene under chapter 6's solver and repeats every stage of each step on the side, from the same
/// prediction and on copies of the list that hold one kind, whole passes long: reading a clock takes as long
/// as handling a pair. Nothing of it is applied. Categorisation is a part of the redefinition pass; the
/// difference of the two passes is what `redefine` says.
/// @param from  the first step that counts; those before run without clocks
PairTimes time_stages(Scene& scene, int steps, int from = 0);

}  // namespace enduring::chapter06
