#pragma once

namespace enduring {

/// A contact spring. Depths are negative inside; the spring is pressed where the depth is below its rest
/// offset.
struct Spring {
    double k;     ///< stiffness [N/m]
    double rest;  ///< rest offset [m]
};

/// The requirements of a pair for its spring.
struct Pair {
    double mass;    ///< that the pair feels [kg]
    double load;    ///< carried in the last step [N]
    double wanted;  ///< the depth to which a load may press it [m], positive
};

/// The stiffness that a pair requires [N/m]: from its load, at least 100 m / dt^2 and at most 10^7 m / dt^2.
double asked_stiffness(const Pair& pair, double dt);

/// The energy that a spring stores [J]. @param depth  [m]
double energy(const Spring& spring, double depth);

/// The spring with another stiffness. If it is pressed, its force at this depth does not change; otherwise
/// its rest offset does not change.
Spring with_stiffness(const Spring& spring, double k, double depth);

/// The spring at the start of a step. It becomes stiffer at once, but softer only if it is more than twice as
/// stiff as the pair requires.
Spring adapted(const Spring& spring, const Pair& pair, double depth, double dt);

/// The rest offset of the next step [m]. A negative rest offset fades by a tenth in a step, but no faster
/// than `fastest`; other rest offsets do not change.
/// @param fastest  [m/s]
double faded(double rest, double fastest, double dt);

}  // namespace enduring
