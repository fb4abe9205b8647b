#pragma once

/// From when geometry counts as degenerate. All are ratios, so millimetres and kilometres are judged alike; a
/// double keeps sixteen digits, and what is left of them after a cancellation decides each.
namespace enduring::tolerance {

/// Of a face's double area to its longest side squared: below, four digits of its normal are left.
inline constexpr double least_area = 1e-12;

/// Of a volume to the cube of its longest edge or extent: a flatter element has lost its gradients.
inline constexpr double least_volume = 1e-12;

/// Of a body's least moment of inertia to its largest: below, its points lie on one line, by a millionth of
/// their extent.
inline constexpr double least_inertia = 1e-12;

/// Of a middle node's distance from the middle of its edge to the edge: files hold six digits or more.
inline constexpr double straight_edge = 1e-6;

/// One plus the cosine of two directions that count as opposite: between them any axis may turn.
inline constexpr double opposite = 1e-12;

/// Sine of the angle of two sides: below, it is lost in rounding, and they span no normal at all.
inline constexpr double least_sine = 1e-12;

/// The same for a normal that is to tell on which side a feature lies: half of its digits are left.
inline constexpr double trusted_sine = 1e-8;

/// Length of a mean of unit normals: below, they have cancelled, as on both sides of a sheet.
inline constexpr double cancelled = 1e-9;

}  // namespace enduring::tolerance
