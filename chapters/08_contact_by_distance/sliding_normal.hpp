#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// The normal of the path on which a vertex comes along a surface that bends in this step: of the normals
/// from that of the start to as far before it as that of the end lies behind it, the one along which the
/// vertex does not move.
///
/// @param start   unit normal of the surface under the vertex when the step begins
/// @param end     unit normal of the pair at the end of the step
/// @param motion  of the vertex against the surface, as it would be without the forces of this step [m]
/// @return        a unit vector; zero where the surface is flat, or the vertex does not come along it but
///     hits it
Vec3 sliding_normal(const Vec3& start, const Vec3& end, const Vec3& motion);

}  // namespace enduring
