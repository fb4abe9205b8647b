#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// The rotation nearest to a deformation gradient F: the R of F = R S with S symmetric and det R = +1.
///
/// Always a rotation, also for a flat or inverted F: then S takes the reflection along the
/// direction in which the element is thinnest, the shortest way back to a sound shape (Irving,
/// Teran, Fedkiw 2004). Depends on F alone, not on the past.
Mat3 polar_rotation(const Mat3& f);

}  // namespace enduring
