#pragma once

#include "common/scenes/scene.hpp"
#include "common/simulation/rigid_body.hpp"

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

}  // namespace enduring::chapter08::formula_runs
