#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace enduring {

/// Points and vectors are columns of three doubles; lengths are in metres unless said otherwise.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// The point at tau in [0, 1] of a straight way; exactly `start` at 0 and `end` at 1.
inline Vec3 lerp(const Vec3& start, const Vec3& end, double tau) { return (1 - tau) * start + tau * end; }

}  // namespace enduring
