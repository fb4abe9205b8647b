#pragma once

#include "common/geometry/vector.hpp"

#include <cmath>

namespace enduring {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

/// Two unit vectors at right angles to a normal and to each other:
/// coordinates for everything that happens along a surface.
class TangentPlane {
public:
    /// @param normal  unit length
    /// @see Duff et al. 2017, "Building an orthonormal basis, revisited"
    explicit TangentPlane(const Vec3& normal)
    {
        const double sign = std::copysign(1.0, normal.z());
        const double a = -1 / (sign + normal.z()), b = normal.x() * normal.y() * a;
        axes_.col(0) << 1 + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x();
        axes_.col(1) << b, sign + normal.y() * normal.y() * a, -normal.y();
    }

    Vec2 of(const Vec3& v) const { return axes_.transpose() * v; }
    Vec3 in_space(const Vec2& v) const { return axes_ * v; }
    Vec3 projected(const Vec3& v) const { return in_space(of(v)); }
    /// How a matrix acts along the plane.
    Mat2 of(const Mat3& m) const { return axes_.transpose() * m * axes_; }

private:
    Eigen::Matrix<double, 3, 2> axes_;
};

}  // namespace enduring
