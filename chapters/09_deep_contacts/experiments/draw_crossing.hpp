#pragma once

#include "chapters/09_deep_contacts/overlaps.hpp"
#include "common/experiments/render/stage.hpp"
#include "common/simulation/step.hpp"

namespace enduring::chapter09 {

/// Red lines along all curves in which two surfaces cross.
void draw_curves(Stage& stage, const Intersection& intersection, const StillSurface& a,
                 const StillSurface& b);

/// Where the first two bodies of a world are in each other.
struct Crossing {
    std::size_t curves = 0, piercings = 0;
    std::size_t regions = 0;  ///< into which the curves cut the second body's surface
    long first_inside = 0,
         second_inside = 0;  ///< vertices of the first body in the second one, and the other way
};

/// Makes both bodies pale, the first one more, draws the curves in which they cross, and dots at the vertices
/// inside: those of the first body blue, those of the second one orange.
Crossing mark_crossing(Stage& stage, const World& world);

/// Dots at the vertices that are in the other surface; returns how many.
long mark_inside(Stage& stage, const SurfaceRegions& regions, const StillSurface& surface, const Vec3& color);

}  // namespace enduring::chapter09
