#pragma once

#include <vector>

namespace enduring {

/// An impulse along one direction. It decreases with the velocity u along this direction, between two bounds:
///   p(u) = max(low, min(high, -(bias + slope u)))
struct Line {
    double bias = 0;   ///< [N s]
    double slope = 0;  ///< [kg], not negative
    double low = 0;    ///< [N s], may be minus infinity
    double high = 0;   ///< [N s], may be infinity
};

/// The impulse at a velocity u [m/s].
double impulse(const Line& line, double u);

/// The floor below a lift. Its spring only pushes upwards, and is compressed by `depth` at the start of the
/// step.
/// @param stiffness  [N/m]
/// @param depth      distance of the lift below the floor [m], positive inside
/// @param dt         length of the step [s]; the force is that at the end of the step
Line floor_line(double stiffness, double depth, double dt);

/// A rope that holds the lift from above and only pulls upwards. At the start of the step it is slack by
/// `slack` [m]; a negative number means that it is stretched.
Line rope_line(double stiffness, double slack, double dt);

/// A brake with the largest force `most` [N]: it holds the lift still if this force is enough.
/// @param hold  slope of the line while the force is below its largest value [kg]
Line brake_line(double most, double hold, double dt);

/// The velocity u of a lift after the step: mass (u - free_velocity) is the sum of the impulses of all lines.
/// @param mass           [kg], positive
/// @param free_velocity  of the lift without lines [m/s]
double velocity_after(double mass, double free_velocity, const std::vector<Line>& lines);

}  // namespace enduring
