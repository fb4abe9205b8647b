#pragma once

#include "chapters/08_contact_by_distance/experiments/driven_scenes.hpp"

namespace enduring::chapter08 {

/// Limits between what holds and what does not, each by halving the interval that holds it.

/// Angle up to which a block with mu stays on a slope: atan(mu) [degrees].
AgainstFormula slope_limit(double mu, double dt);

/// Angle at which a box on a rough slope begins to topple: atan(width / height) [degrees].
AgainstFormula toppling_limit(double height_over_width, double dt);

/// Coefficient with which two jaws hold a wedge that they press: tan of the angle of each side.
AgainstFormula pinch_limit(double side_deg, double dt);

/// Thickness over radius, to the middle, of the thinnest half circle of stones that stands. Its formula is
/// that of its number of stones: hinges are at joints.
AgainstFormula arch_limit(int stones, double dt);
/// Of the same stones, from the thrust: at each joint it has to pass above the inner corner, and at the
/// ground within the outer one. With many stones 0.1075 (Milankovitch 1907).
double thinnest_arch(int stones);

}  // namespace enduring::chapter08
