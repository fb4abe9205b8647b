#pragma once

#include "chapters/engines/engine.hpp"

#include <string>
#include <vector>

namespace enduring::engines {

/// What is judged is where bodies are: no engine is asked about its contacts, forces or velocities.

/// Our bodies where a frame has them, so that true_depth() can look at them.
World world_at(const EngineScene& scene, const Frame& frame);

/// The deepest that bodies are in each other or below planes, whatever the engine says [um].
double depth_um(const EngineScene& scene, const Frame& frame);

/// Of the fastest centre, by where it is at half time and at the end [um/s].
double drift_um_per_s(const EngineScene& scene, const Trajectory& run);

/// Of the centre that ends farthest from its start [mm].
double moved_mm(const Trajectory& run);

/// Of the fastest centre upwards from frame to frame, in the whole run [m/s].
double thrown_m_per_s(const EngineScene& scene, const Trajectory& run);

/// The part of its first angle to which a body comes back after one period in a pipe about z; 0 if it stops
/// before.
double amplitude_kept(const Trajectory& run, std::size_t body);

/// The mean acceleration of a body along a direction in the last two thirds of a run [m/s^2].
double acceleration(const EngineScene& scene, const Trajectory& run, std::size_t body, const Vec3& along);

/// Whether all bodies are somewhere within 1 km.
bool is_finite(const Trajectory& run);

/// The least mean of twenty frames in a row of the second half [ms]: other work on the machine counts less.
double ms_at_rest(const Trajectory& run);

}  // namespace enduring::engines
