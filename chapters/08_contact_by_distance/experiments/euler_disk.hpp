#pragma once

namespace enduring::chapter08 {

/// A flat prism of 0.1 m radius that goes round on its rim, its centre at rest, and rolls.
struct EulerDisk {
    int sides = 96;
    double lean_deg = 20;  ///< of its faces from the ground
    double mu = 1;
    double dt = 0.001;         ///< [s]
    double thickness = 0.002;  ///< [m]
};

struct DiskRun {
    double rate = 0,
           by_formula = 0;  ///< mean rate at which the axis goes round, and of the formula at each moment's
                            ///< lean [rad/s]
    double lean_change_deg = 0;  ///< at the end, against the start
    double energy_change = 0;    ///< at the end, over the energy at the start
    double centre_moved_mm = 0;  ///< along the ground, at the end
};

/// Rate of steady rolling with the centre at rest [rad/s]: rate^2 sin(lean) (A cos(lean) - C sin(lean) b/a)
/// = m g (a cos(lean) - b sin(lean)). Of a thin disk it is Euler's disk, rate^2 = 4 g / (a sin(lean)).
/// @param radius, half_thickness     a and b [m]
/// @param across_per_kg, along_per_kg  A across the axis and C about it, over the mass [m^2]
/// @param lean                       [rad]
double disk_rate(double radius, double half_thickness, double across_per_kg, double along_per_kg,
                 double lean);

DiskRun spin_disk(const EulerDisk& disk, double duration);

}  // namespace enduring::chapter08
