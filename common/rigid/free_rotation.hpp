#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// One step of a body that turns freely (thesis 3.6 without torque): angular velocity in body axes after dt.
///
/// Solves  exp(Theta) J w1 = J w0  with  Theta = dt (w0 + w1) / 2,  where exp(Theta) is the turn by the
/// vector Theta. The equation says that the angular momentum stays where it is in space while the body turns
/// by the mean of both velocities. Energy then stays as well: w1.J w1 - w0.J w0 = (w0 + w1).(J w1 - J w0),
/// and a turn about Theta leaves the component along Theta of any vector, here J w1, as it was.
///
/// @param principal_inertia  J, diagonal, positive [kg m^2]
/// @param w0                 angular velocity in body axes [rad/s]
/// @param dt                 length of the step [s]; accurate to second order
/// @return                   w1 [rad/s]; w0 where Newton finds no answer
///     (from turns of about two radians a step on)
/// @see Simo and Wong 1991, "Unconditionally stable algorithms for rigid body dynamics that exactly preserve
///      energy and momentum", ALGO-C1
Vec3 freely_turned(const Vec3& principal_inertia, const Vec3& w0, double dt);

}  // namespace enduring
