#pragma once

#include "chapters/13_other_solvers/barrier_distances.hpp"
#include "chapters/13_other_solvers/method_step.hpp"

#include <vector>

namespace enduring {

//! [log_barrier]
/// The barrier over the ratio r = d^2 / d^hat^2 of squared distances, with its derivatives: -(r - 1)^2 ln r
/// below r = 1, and 0 from there on.
struct BarrierValue {
    double value = 0, slope = 0, bend = 0;
};
/// @param ratio  positive
/// @see Li et al. 2020, (6), which is the same of d and d^hat; their program and this one take squares
BarrierValue log_barrier(double ratio);
//! [log_barrier]

/// Of all bodies of a step, and of all nodes of soft ones.
struct Places {
    std::vector<Pose> poses;
    std::vector<Vec3> nodes;
};

/// Two features within d^hat. Many pairs of features have the same nearest corners, as those around one edge:
/// they count together.
struct BarrierTerm {
    std::size_t point;  ///< the first of them, in MethodStep::points
    FourPoints x;
    NearestPoints nearest;
    Derivatives mollifier;  ///< 1 for all but edges that are nearly parallel
    double count = 1;
    BarrierValue barrier;

    /// count kappa e(x) b(d^2 / d^hat^2), by the corners [J].
    Derivatives potential(const ContactPoint& pair, double kappa, double distance) const;
};

/// Places of pairs in MethodStep::points, ascending.
using PairPlaces = std::vector<std::size_t>;
/// The pairs whose features have boxes that are nearer than this to each other along each axis [m], and all
/// with planes. Most pairs of a step never come so near.
PairPlaces near_pairs(const MethodStep& step, const Places& places, double distance);

/// @param among     the pairs to look at
/// @param distance  d^hat [m], positive
std::vector<BarrierTerm> barrier_terms(const MethodStep& step, const PairPlaces& among, const Places& places,
                                       double distance);

/// When the first pair meets, in (0, 1], if all vertices go straight from place to place; 1 too if none does.
/// By chapter 2's certified query.
/// @return  and whether one meets
std::pair<double, bool> first_meeting(const MethodStep& step, const PairPlaces& among, const Places& from,
                                      const Places& to, double distance);

/// In the world [m]; of a pair with a plane the first alone.
FourPoints corners_of(const ContactPoint& pair, const Places& places);

}  // namespace enduring
