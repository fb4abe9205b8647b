#pragma once

#include "common/geometry/vector.hpp"

#include <LinearMath/btQuaternion.h>
#include <LinearMath/btVector3.h>

namespace enduring::bullet {

inline btVector3 to_bullet(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline btQuaternion to_bullet(const Quaternion& q) { return {q.x(), q.y(), q.z(), q.w()}; }
inline Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace enduring::bullet
