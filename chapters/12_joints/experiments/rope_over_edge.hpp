#pragma once

namespace enduring::chapter12 {

/// A rope of equal links around a part of a drum. The middle of each link lies on a corner of the drum, and
/// the pins between links lie in the middle of the drum's faces: there a pull along the rope has no moment
/// about the corner that its link could not take.
struct RopeOverEdge {
    double angle = 3;  ///< around which the rope lies [rad]
    int links = 12;
    double mu = 0.3;
    double radius = 0.3;  ///< of the drum's corners [m]
};

/// The largest ratio of the pulls at both ends at which friction still holds. A link turns the rope by d and
/// carries the pulls T and q T, so it presses with N = (q + 1) T sin(d/2), and friction gives
/// (q - 1) T cos(d/2) = mu N. With many links this is Euler's exp(mu angle).
double largest_ratio(const RopeOverEdge& rope);

struct RopePull {
    double displacement = 0;  ///< of the middle link towards the larger pull [m]
    double error = 0;         ///< of its joints [m, rad]
};

/// Pulls one end with 1 N and the other one by a ratio more, without gravity.
RopePull pull_rope(const RopeOverEdge& rope, double ratio, double duration);

}  // namespace enduring::chapter12
