#pragma once

#include "common/geometry/vector.hpp"

#include <array>

namespace enduring {

/// The units of an engine, in our units.
struct EngineUnits {
    double length;  ///< [m]
    double mass;    ///< [kg]
    double time;    ///< [s]
};

/// A box in our scenes.
struct OurBox {
    Vec3 size;                          ///< its edges [m]
    double mass;                        ///< [kg]
    Vec3 inertia;                       ///< about its centre, along its edges [kg m^2]
    Vec3 velocity;                      ///< [m/s]
    Vec3 angular_velocity;              ///< [rad/s]
    std::array<double, 4> orientation;  ///< unit quaternion: w, x, y, z
    double mu;                          ///< coefficient of friction against another box of its kind
};

/// The same box in the engine's units and conventions.
struct TheirBox {
    Vec3 half_size;
    double mass;
    Vec3 inertia, velocity, angular_velocity;
    std::array<double, 4> orientation;  ///< unit quaternion: x, y, z, w
    double friction;                    ///< the engine's mu is the product of this number of both bodies
};

/// The settings of a scene: ours in m/s^2, s and m, the engine's in its units.
struct WorldSettings {
    Vec3 gravity;
    double dt;
    double slop;  ///< the depth up to which bodies may overlap before the engine pushes
};

/// A box in the engine's units and conventions.
TheirBox box_for(const EngineUnits& units, const OurBox& box);

/// The settings of our scene in the engine's units.
WorldSettings settings_for(const EngineUnits& units, const WorldSettings& ours);

/// An impulse computed by the engine, in our units [N s].
Vec3 impulse_from(const EngineUnits& units, const Vec3& theirs);

}  // namespace enduring
