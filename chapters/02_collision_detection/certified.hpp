#pragma once

#include "chapters/02_collision_detection/query.hpp"

namespace enduring {

/// The reported time lies before the true one by at most this part of the
/// step, for every crossing that is not tangent.
constexpr double time_of_impact_slack = 0x1p-34;

/// First time at which the closed features touch, certified.
///
/// For finite coordinates that move on straight lines, and IEEE
/// doubles rounded to nearest without contraction:
///   - nothing is returned only if the features touch at no time in [0, 1];
///   - a returned time is not later than the first touch, but for its own rounding (2^-53);
///   - it precedes the first touch by at most `time_of_impact_slack`
///     where they cross with heights and sides that
///     106 bits can tell from zero, that is, larger than about 2^-95 of
///     the products of coordinate differences that
///     they are made of. Nearer misses than that count as touches, at the
///     time where they can no longer be excluded.
/// One query takes at most 128 proofs of bounded cost, so its time has a bound too; when they run out,
/// the earliest time not yet excluded is returned.
/// @return tau in [0, 1]
/// @throws std::invalid_argument  a coordinate is not finite
std::optional<double> time_of_impact(const VertexFaceStep& step);
std::optional<double> time_of_impact(const EdgeEdgeStep& step);

/// First touch not before `from`, in [0, 1]; for `from` = 0 the same as above. To look for the
/// next touch after a crossing at `time`, start from time + 2 time_of_impact_slack: if the
/// answer is that time again, the features have not parted.
std::optional<double> time_of_impact(const VertexFaceStep& step, double from);
std::optional<double> time_of_impact(const EdgeEdgeStep& step, double from);

/// Which part of the query settled it.
enum class QueryStage {
    height,         ///< the sign of the four coefficients of the height, in doubles
    doubles,        ///< the search with doubles
    double_doubles  ///< the search with 106 bits
};

struct CertifiedAnswer {
    std::optional<double> time;  ///< as time_of_impact returns it
    QueryStage stage;
};

/// time_of_impact, and what it took.
CertifiedAnswer certified_answer(const VertexFaceStep& step);
CertifiedAnswer certified_answer(const EdgeEdgeStep& step);

}  // namespace enduring
