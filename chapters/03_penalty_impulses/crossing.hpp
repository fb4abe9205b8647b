#pragma once

#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/03_penalty_impulses/penetration.hpp"

#include <optional>

namespace enduring {

using PairWeights = std::array<double, 4>;  ///< p - q = sum of weight times vertex; their sum is zero

/// A moment at which two features touch, and how they go on from there.
struct Crossing {
    double time = 0;  ///< in [0, 1]
    /// 1 where the depth along the plain normal (5.12, 5.18) falls, -1 where
    /// it rises, 0 where the features have no normal.
    double orientation = 0;
    PairWeights weights{};  ///< of the touching points at that time, none outside its feature
};

/// What happens at a touch that chapter 2's query found.
/// @param time  of the touch, in [0, 1]
Crossing crossing_at(const VertexFaceStep& step, double time);
Crossing crossing_at(const EdgeEdgeStep& step, double time);

/// A cubic has three roots, so a pair crosses at most three times in a step.
constexpr int max_crossings = 3;

//! [find_entry]
/// The first crossing that leads from outside to inside. One that leads out is passed over: the query is
/// asked again for the rest of the step.
/// @param step    VertexFaceStep or EdgeEdgeStep
/// @param enters  says of a Crossing whether it leads inside
template <class Step, class Enters>
std::optional<Crossing> find_entry(const Step& step, const Enters& enters)
{
    std::optional<double> touch = time_of_impact(step);
    for (int i = 0; i < max_crossings && touch; ++i) {
        const Crossing crossing = crossing_at(step, *touch);
        if (enters(crossing))
            return crossing;
        const double after = *touch + 2 * time_of_impact_slack;
        if (after > 1)
            return std::nullopt;
        touch = time_of_impact(step, after);
    }
    return std::nullopt;
}
//! [find_entry]

/// A face knows which of its sides is out: its vertex pairs enter where the depth falls.
inline bool enters_face(const Crossing& crossing) { return crossing.orientation > 0; }

/// An edge pair's normal has no side of its own. Motion gives it one, against which the
/// depth falls; but a crossing that leads out, seen backwards, looks the same. The
/// surfaces decide: a normal from B to A leaves B and enters A.
/// @param outward  outward direction of B at its edge minus that of A at its own
bool enters_edge(const EdgeEdgeStep& step, const Crossing& crossing, const Vec3& outward);

}  // namespace enduring
