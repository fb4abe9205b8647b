#pragma once

namespace enduring::chapter08 {

/// A wheel with flat sides that rolls down a slope without slip or bounce: it turns about the edge that
/// carries it, until the next edge lands.
struct RimlessWheel {
    int sides = 16;
    double radius = 0.2;  ///< of its edges [m]
    double mass = 20;     ///< [kg]
    double inertia = 0;   ///< about its axis [kg m^2]
    double slope = 0;     ///< [rad]
    double angle = 0;     ///< of the edge that carries, behind the normal through the axis [rad]
    double rate = 0;      ///< [rad/s], positive down the slope

    /// What a landing leaves of the rate: the angular momentum about the new edge stays.
    double kept() const;
    /// Rolls on for some time [s], in small steps.
    void roll(double time);
    /// The force along the normal by which the edge is pressed on [N]; negative where it would have to pull.
    double pressed() const;
};

}  // namespace enduring::chapter08
