#pragma once

#include <vector>

namespace enduring {

/// An impulse along one direction that falls with the velocity u along it, cut off at two bounds:
///   p(u) = max(low, min(high, -(bias + slope u)))
struct Line {
    double bias = 0;   ///< [N s]
    double slope = 0;  ///< [kg], not negative
    double low = 0;    ///< [N s], may be minus infinity
    double high = 0;   ///< [N s], may be infinity
};

/// The impulse at a velocity u [m/s].
double impulse(const Line& line, double u);

/// What keeps a lift from falling through its floor: it pushes upwards only, and is pressed by `depth` where
/// the step begins.
/// @param stiffness  [N/m]
/// @param depth      how far the lift is below the floor [m], positive inside
/// @param dt         length of the step [s]; the spring is that of the end of the step
Line floor_line(double stiffness, double depth, double dt);

/// A rope that holds the lift from above and pulls upwards only. It is slack by `slack` [m] where the step
/// begins, below zero if it is stretched.
Line rope_line(double stiffness, double slack, double dt);

/// A brake with a largest force [N]: it holds the lift still, if it can.
/// @param hold  slope of the line while the force is below its largest [kg]
Line brake_line(double most, double hold, double dt);

/// The velocity of a lift behind the step: mass (u - free_velocity) is the sum of what all lines push at u.
/// @param mass           [kg], positive
/// @param free_velocity  that it would have without lines [m/s]
double velocity_after(double mass, double free_velocity, const std::vector<Line>& lines);

}  // namespace enduring
