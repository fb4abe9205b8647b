#pragma once

#include "common/geometry/meshes.hpp"

namespace enduring::chapter08 {

/// A spur gear with involute flanks.
struct GearShape {
    int teeth = 18;  ///< from 17, where the rack that cuts it leaves its flanks whole, to 41, where roots
                     ///< grow over the base circle
    double module = 0.01;      ///< pitch diameter over teeth [m]
    double width = 0.02;       ///< [m]
    double pressure_deg = 20;  ///< between the line of action and the common tangent of the pitch circles
    double play = 2e-4;        ///< taken from each tooth's thickness at the pitch circle [m]
    int flank_points = 8;      ///< facets of a flank

    double pitch_radius() const { return 0.5 * module * teeth; }
};

/// About z, a tooth along x; closed.
/// @throws InputError  teeth outside 17 to 41, or no facets
SurfaceMesh gear(const GearShape& shape);

/// Torques [N m]: the gears' ratio leaves a fifth of the first.
inline constexpr double drive_torque = 4, brake_torque = 4.8;

/// Two gears without friction: a torque drives the one, a smaller one resists at the other.
struct GearPair {
    int teeth = 18, other_teeth = 27;
    int flank_points = 8;
    double dt = 0.001;  ///< [s]
};

struct GearRun {
    double turns = 0;             ///< of the driven gear
    double ratio = 0, exact = 0;  ///< of the angles
    double apart_um = 0;  ///< largest departure from the ratio after the first touch, along the pitch circle
    double acceleration = 0,
           by_formula = 0;  ///< of the gear with the torque: (T - T' z/z') / (I + I' (z/z')^2) [rad/s^2]
    double lost = 0;        ///< part of the torques' work that is not in the motion at the end
    long unconverged = 0;
};

/// Runs it until the driven gear has made so many turns.
GearRun turn_gears(const GearPair& pair, double turns);

}  // namespace enduring::chapter08
