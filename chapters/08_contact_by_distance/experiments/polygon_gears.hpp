#pragma once

#include "chapters/08_contact_by_distance/experiments/gears.hpp"

namespace enduring::chapter08 {

/// Two gears as rigid polygons in a plane, by two angles alone: no search, no springs, no solver of this
/// course.
///
/// For each angle of the first gear, teeth bound the angle of the second one on both sides. Between the
/// bounds both turn freely; a bound stops them against each other without a bounce. Steps are a hundredth of
/// the pair's, so facets land one by one.
/// @return  angular acceleration of the first gear from 0.2 rad on, up to so many turns [rad/s^2]
double acceleration_of_polygons(const GearPair& pair, double turns);

}  // namespace enduring::chapter08
