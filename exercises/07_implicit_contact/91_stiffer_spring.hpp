#pragma once

namespace enduring {

/// A contact spring. Depths are negative inside; the spring is pressed where the depth is below its rest
/// offset.
struct Spring {
    double k;     ///< stiffness [N/m]
    double rest;  ///< rest offset [m]
};

/// What a pair asks of its spring.
struct Pair {
    double mass;    ///< that its impulses feel [kg]
    double load;    ///< that it carried in the last step [N]
    double wanted;  ///< the depth to which a load may press it [m], positive
};

/// The stiffness that a pair asks for [N/m]: by its load, at least 100 m / dt^2 and at most 10^7 m / dt^2.
double asked_stiffness(const Pair& pair, double dt);

/// The energy that a spring holds [J]. @param depth  [m]
double energy(const Spring& spring, double depth);

/// The spring with another stiffness. If it is pressed, its force at this depth stays; else its rest offset
/// does.
Spring with_stiffness(const Spring& spring, double k, double depth);

/// The spring at the start of a step. It becomes stiffer at once, and softer only if it is more than twice as
/// stiff as the pair asks for.
Spring adapted(const Spring& spring, const Pair& pair, double depth, double dt);

/// The rest offset of the next step [m]. A negative one fades by a tenth in a step, and no faster than by a
/// speed; others stay.
/// @param fastest  [m/s]
double faded(double rest, double fastest, double dt);

}  // namespace enduring
