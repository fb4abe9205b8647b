#pragma once

#include <Eigen/Core>

namespace enduring {

/// What pairs answer to an impact, seen by the pairs alone: velocities along their normals [m/s], negative while they approach,
/// and the response W, the change of these velocities per impulse [1/kg], symmetric and never negative.
/// @see Smith, Kaufman, Vouga, Tamstorf, Grinspun: Reflections on simultaneous impact, ACM TOG 31(4), 2012

/// The impulses [N s], none negative, after which no pair approaches and none that got one separates: the impact without restitution.
/// @param velocities  before
Eigen::VectorXd stopping_impulses(const Eigen::MatrixXd& response, const Eigen::VectorXd& velocities);

/// The sum of the impulses of generalized reflections: those pairs that approach are stopped together and sent back by as much
/// again, which keeps the kinetic energy; so with those that approach now, until none does.
Eigen::VectorXd reflecting_impulses(const Eigen::MatrixXd& response, const Eigen::VectorXd& velocities);

/// The largest part, up to 1, of some impulses with which the kinetic energy changes by no more than is allowed:
/// part slope + part^2 curvature / 2 <= allowed.
/// @param slope      impulses . velocities before [J]
/// @param curvature  impulses . W impulses [J]
/// @param allowed    [J]; below zero, nothing is
double allowed_part(double slope, double curvature, double allowed);

}  // namespace enduring
