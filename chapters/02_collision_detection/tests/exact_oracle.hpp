#pragma once

#include "chapters/02_collision_detection/query.hpp"
#include "chapters/02_collision_detection/tests/integer_polynomial.hpp"

namespace enduring::exact {

/// The first touch, enclosed: the exact time lies in [low, high], at most 2^-70 apart.
struct FirstTouch {
    Dyadic low, high;
    double time() const { return high.rounded(); }
};

/// The truth about a query: coordinates become integers by a common
/// power of two, and nothing is ever rounded.
///
/// It takes the textbook's way (roots of the cubic, barycentric weights by the normal) with
/// exact signs at algebraic numbers, and tries points on segments where the normal
/// vanishes; so it shares no formula with the certified query.
std::optional<FirstTouch> first_touch(const VertexFaceStep& step);
std::optional<FirstTouch> first_touch(const EdgeEdgeStep& step);

}  // namespace enduring::exact
