#pragma once

#include "common/geometry/tolerances.hpp"
#include "common/geometry/vector.hpp"

#include <cmath>

namespace enduring {

/// The shortest turn that takes one direction to another, about their cross product; where they are opposite,
/// half a turn about some axis at right angles. As Eigen's Quaternion::FromTwoVectors, but without its SVD
/// for the opposite ones, in which g++ 13 sees memory that is read before it is written. Its error is a
/// rounding over 1 + cosine of the angle.
/// @param from, to  any length but zero
/// @return          of unit length
inline Quaternion shortest_turn(const Vec3& from, const Vec3& to)
{
    const Vec3 a = from.normalized(), b = to.normalized();
    const double cosine = b.dot(a);
    if (cosine < -1 + tolerance::opposite)
        return Quaternion(Eigen::AngleAxisd(std::acos(-1.0), a.unitOrthogonal()));
    const double s = std::sqrt((1 + cosine) * 2);  // twice the cosine of half the angle
    Quaternion turn;
    turn.vec() = a.cross(b) * (1 / s);
    turn.w() = s * 0.5;
    return turn;
}

}  // namespace enduring
