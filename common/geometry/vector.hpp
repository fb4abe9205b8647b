#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace enduring {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

}  // namespace enduring
