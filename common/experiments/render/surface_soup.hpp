#pragma once

#include "common/experiments/render/stage.hpp"
#include "common/experiments/render/triangle_soup.hpp"

namespace enduring {

/// Flat normals, or with `smooth` their blend over the faces around each
/// vertex that are less than 40 degrees apart.
void add_surface(TriangleSoup& soup, const Drawable& body, const Vec3& centre);

}  // namespace enduring
