#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace enduring {

/// Points and vectors are columns of three doubles; lengths are in metres unless said otherwise.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

}  // namespace enduring
