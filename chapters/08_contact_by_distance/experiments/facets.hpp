#pragma once

namespace enduring::chapter08 {

/// A prism that rolls down 10 degrees from 0.7 m/s: mean speed of its edges around its axis, from 0.2 s to
/// 0.5 s [m/s].
struct PrismRoll {
    double measured, by_wheel;  ///< and that of the rimless wheel of the same shape
    double round;               ///< and of a round body of the same inertia
    double kept;                ///< part of the speed that a landing leaves
    double least_pressed;       ///< least force that presses the wheel's edge on [N]
};

PrismRoll roll_prism(int sides, double dt);

}  // namespace enduring::chapter08
