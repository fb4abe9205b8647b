#pragma once

#include "common/scenes/scene.hpp"
#include "common/simulation/rigid_body.hpp"

#include <cmath>
#include <numbers>

/// What experiments against a formula share.
namespace enduring::chapter08::formula_runs {

inline constexpr double earth = 9.81;                     ///< [m/s^2]
inline constexpr double degree = std::numbers::pi / 180;  ///< [rad]

/// @throws std::bad_cast  the body is not rigid
inline const RigidMotion& motion_of(const Scene& scene, std::size_t body)
{
    return dynamic_cast<const RigidBody&>(*scene.world.bodies[body]).motion();
}

/// By how much a direction has gone round the vertical [rad].
inline double turn_about_y(const Vec3& before, const Vec3& after)
{
    return std::atan2(before.z() * after.x() - before.x() * after.z(),
                      before.x() * after.x() + before.z() * after.z());
}

}  // namespace enduring::chapter08::formula_runs
