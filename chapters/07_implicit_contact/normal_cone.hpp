#pragma once

#include "chapters/05_categorisation/normal_span.hpp"

namespace enduring {

/// Whether some direction of the cone that normals span lies within an angle of a direction: of all their
/// sums with weights that are not negative. Chapter 5 asks the normals and their average only, and a sharp
/// tip has much room between these.
/// @param normals    unit length
/// @param direction  any length but zero
/// @param cosine     of the angle, positive
bool cone_reaches(std::span<const Vec3> normals, const Vec3& direction, double cosine);

/// The same for the faces of a vertex or an edge, as span_reaches() has it: those without area are passed
/// over, and true if there are none.
bool cone_reaches(const SurfaceMoment& surface, std::span<const int> faces, const Vec3& direction,
                  double cosine);

}  // namespace enduring
