#pragma once

#include "common/scenes/scene.hpp"

#include <filesystem>
#include <functional>

namespace enduring::chapter04 {

/// The box of the scene `block_on_slope`, under other circumstances:
/// 100 kg on 1 m x 1 m, on a plane, with a push.
struct Launch {
    double angle_deg = 10;
    double dt = 0.01;     ///< [s]
    double height = 0.1;  ///< of the box [m]; 1 makes it a cube
    double speed = 3;     ///< uphill, at first [m/s]
    FrictionParameters friction{};
};

/// mu_d of all launches: 0.1, or half of mu_s where that is less.
FrictionParameters with_mu_s(const FrictionParameters& friction, double mu_s);

/// The scene, the box as deep in its slope as it would rest.
Scene scene_of(const Launch& launch);

/// Unit vector uphill.
Vec3 uphill(double angle_deg);

/// Where the box is along the slope, and how fast [m, m/s].
struct Progress1d {
    double time, way, speed;
};
Progress1d along_slope(const World& world, double angle_deg);

/// Runs a launch and shows every step to `watch`, until the time is up or it returns false.
/// @param seconds  longest time [s]
void follow(const Launch& launch, double seconds, const std::function<bool(const Progress1d&)>& watch);

/// Does it come to rest: less than 1 mm of way between the lowest and the highest point of the last 5 s?
bool holds(const Launch& launch);

/// The smallest mu_s that holds, to 0.5 %, by bisection between 0.8 and 4 tan(angle).
/// @return  not a number if the upper end does not hold
double smallest_mu_s(Launch launch);

/// Mean acceleration between two speeds of a launch [m/s^2], uphill
/// positive; not a number if it never gets there.
double mean_acceleration(const Launch& launch, double from_speed, double to_speed);

}  // namespace enduring::chapter04
