#pragma once

#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"

namespace enduring::chapter08 {

/// How fast a soft cube is that slides without friction over triangles.
struct SoftSlide {
    double speed;       ///< of its centre down the slope at the end [m/s]
    double by_formula;  ///< g sin(10 degrees) times the time [m/s]
};

/// @param duration  [s]; the cube is let go 0.1 mm above the triangles
SoftSlide slide_without_friction(const chapter07::SoftCube& cube, double duration);

}  // namespace enduring::chapter08
