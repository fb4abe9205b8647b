#pragma once

#include "common/geometry/vector.hpp"

#include <array>

namespace enduring {

/// What an engine counts in, each in our units.
struct EngineUnits {
    double length;  ///< [m]
    double mass;    ///< [kg]
    double time;    ///< [s]
};

/// A box as our scenes have it.
struct OurBox {
    Vec3 size;                          ///< its edges [m]
    double mass;                        ///< [kg]
    Vec3 inertia;                       ///< about its centre, along its edges [kg m^2]
    Vec3 velocity;                      ///< [m/s]
    Vec3 angular_velocity;              ///< [rad/s]
    std::array<double, 4> orientation;  ///< unit quaternion: w, x, y, z
    double mu;                          ///< coefficient of friction against another one of its kind
};

/// The same as the engine takes it, in the engine's units.
struct TheirBox {
    Vec3 half_size;
    double mass;
    Vec3 inertia, velocity, angular_velocity;
    std::array<double, 4> orientation;  ///< unit quaternion: x, y, z, w
    double friction;  ///< the engine multiplies those of two bodies, and takes the product for mu
};

/// What is set once for a scene. Ours is in m/s^2, s and m, the engine's in its units.
struct WorldSettings {
    Vec3 gravity;
    double dt;
    double slop;  ///< how deep bodies may lie in each other before the engine pushes
};

/// A box in the engine's units and conventions.
TheirBox box_for(const EngineUnits& units, const OurBox& box);

/// The settings of our scene in the engine's units.
WorldSettings settings_for(const EngineUnits& units, const WorldSettings& ours);

/// An impulse that the engine tells, in ours [N s].
Vec3 impulse_from(const EngineUnits& units, const Vec3& theirs);

}  // namespace enduring
