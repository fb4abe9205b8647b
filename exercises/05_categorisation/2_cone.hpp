#pragma once

#include "chapters/05_categorisation/normal_span.hpp"

namespace enduring {

/// All directions within an angle of an axis.
struct Cone {
    Vec3 axis;          ///< unit length
    double half_angle;  ///< [rad], 0 to pi
};

/// The narrowest circular cone that holds all of some directions.
/// @param normals  unit vectors, one to about ten, all within some half space
Cone smallest_cone(std::span<const Vec3> normals);

/// Another rule in the place of the normal span: a pair is regular when the side that B
/// presses on (against the contact normal) lies within 45 degrees of the *cone* of the
/// vertex' face normals, so the gaps between them are filled.
/// @param normals  of the faces around the vertex, unit vectors
/// @param contact_normal  out of B, unit length
bool cone_says_regular(std::span<const Vec3> normals, const Vec3& contact_normal);

}  // namespace enduring
