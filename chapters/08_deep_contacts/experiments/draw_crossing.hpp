#pragma once

#include "chapters/08_deep_contacts/intersection_curve.hpp"
#include "chapters/08_deep_contacts/surface_regions.hpp"
#include "common/experiments/render/stage.hpp"

namespace enduring::chapter08 {

/// Red lines along all curves in which two surfaces cross.
void draw_curves(Stage& stage, const Intersection& intersection, const StillSurface& a,
                 const StillSurface& b);

/// Dots at the vertices that are in the other surface; returns how many.
long mark_inside(Stage& stage, const SurfaceRegions& regions, const StillSurface& surface, const Vec3& color);

}  // namespace enduring::chapter08
