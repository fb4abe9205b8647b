#pragma once

#include "common/scenes/scene.hpp"

#include <functional>

namespace enduring::chapter06 {

/// The block of scene block_on_triangles on a slope of any angle.
struct SlopeTrial {
    double angle_deg = 10;
    /// [s]; k is 200 N s/m over dt, so that CPF's own damping n k dt / 4m ends the landing equally soon
    double dt = 0.01;
    double mu_s = 0.185, mu_d = 0.09;
    double speed = 3;   ///< along the slope, upwards [m/s]
    double start = -3;  ///< along the slope from its middle [m]
};

Scene scene_of(const SlopeTrial& trial);

/// Whether it holds: chapter 4's criterion, less than 1 mm in the last 5 s after it has come up and stopped.
bool holds(const SlopeTrial& trial);

/// The smallest mu_s that holds as a part of tan(angle), by bisection between 0.9 and 1.1, with mu_d =
/// min(0.1, mu_s / 2). A threshold outside comes out as one of these.
double threshold_over_tangent(double angle_deg, double dt);

/// Mean acceleration down the slope between 0.6 s and 1.4 s of a slide that began at 1 m/s downwards [m/s^2].
double slide_acceleration(double angle_deg, double dt, double mu_d);

}  // namespace enduring::chapter06
