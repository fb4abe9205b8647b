#pragma once

#include "chapters/02_collision_detection/query.hpp"

namespace enduring {

/// The tolerances a textbook's query needs. No choice of them is right:
/// what rescues one hard case spoils another.
struct TextbookTolerances {
    /// relative size under which a leading coefficient of the cubic counts as zero
    double coefficient = 1e-12;
    double weight = 1e-9;  ///< how far a barycentric weight may leave [0, 1]
    double time = 0;       ///< how far a root may leave [0, 1]
};

/// First time at which the vertex meets the face: roots of the cubic (4.7), each tried in (4.6).
/// Right for the ordinary case, and wrong or silent where the cubic or the linear system degenerates.
/// @return tau in [0, 1]
/// @see thesis section 4.3
std::optional<double> textbook_time_of_impact(const VertexFaceStep& step,
                                              const TextbookTolerances& tolerances = {});

/// First time at which the edges meet: roots of the cubic (4.11), each tried in (4.10).
std::optional<double> textbook_time_of_impact(const EdgeEdgeStep& step,
                                              const TextbookTolerances& tolerances = {});

}  // namespace enduring
