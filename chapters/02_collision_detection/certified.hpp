#pragma once

#include "chapters/02_collision_detection/query.hpp"

namespace enduring {

/// The reported time lies before the true one by at most this part of the step, for every crossing that is not tangent.
constexpr double time_of_impact_slack = 0x1p-34;

/// First time at which the closed features touch, certified.
///
/// Guarantee, for finite coordinates, linear motion and IEEE doubles rounded to nearest:
///   - no time is returned only if the features do not touch at any time in [0, 1];
///   - a returned time is never later than the first touch;
///   - a returned time precedes the first touch by at most `time_of_impact_slack` where the features cross, or come
///     within 2^-90 of the size of the pair at that time: a nearer miss than that counts as a touch.
/// @return tau in [0, 1]
/// @throws std::invalid_argument  a coordinate is not finite
std::optional<double> time_of_impact(const VertexFaceStep& step);
std::optional<double> time_of_impact(const EdgeEdgeStep& step);

/// First touch not before `from`, in [0, 1]; for `from` = 0 the same as above.
std::optional<double> time_of_impact(const VertexFaceStep& step, double from);
std::optional<double> time_of_impact(const EdgeEdgeStep& step, double from);

}  // namespace enduring
