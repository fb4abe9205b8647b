#pragma once

#include "chapters/engines/engine.hpp"

#include <string>
#include <vector>

namespace enduring::engines {

/// A scene in MuJoCo's own XML, the bodies that move in their order. MuJoCo takes the hull of a mesh, so a
/// static surface that is not convex becomes one wedge a triangle, 5 cm thick.
///
/// A fine way has what the manual tells against slip and softness: elliptic cones, a tenfold impratio, and
/// contacts as stiff as the step allows (solref of two steps).
/// @param step    MuJoCo's own [s]
/// @param buffer  of contacts, which MuJoCo 2 has to be told
/// @see https://mujoco.readthedocs.io/en/stable/modeling.html#preventing-slip
std::string mjcf_of(const EngineScene& scene, const Way& way, double step, bool buffer);

/// The velocities of what moves as MuJoCo keeps them: linear ones in world axes, angular ones in the body's.
std::vector<double> mujoco_velocities(const EngineScene& scene);

constexpr double mujoco_default_step = 0.002;  ///< [s]

}  // namespace enduring::engines
