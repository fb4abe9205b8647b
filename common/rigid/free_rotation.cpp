#include "common/rigid/free_rotation.hpp"

#include <Eigen/LU>

#include <cmath>

namespace enduring {
namespace {

Mat3 cross_matrix(const Vec3& v)
{
    Mat3 m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

/// exp(v): the turn by |v| about v.
Mat3 turn(const Vec3& v)
{
    const double angle = v.norm();
    return angle > 0 ? Eigen::AngleAxisd(angle, v / angle).toRotationMatrix() : Mat3::Identity();
}

/// How exp(v) changes with v: exp(v + dv) = exp(turn_derivative(v) dv) exp(v) to first order.
Mat3 turn_derivative(const Vec3& v)
{
    const double angle = v.norm();
    if (angle < 1e-4)
        return Mat3::Identity() + 0.5 * cross_matrix(v);
    const Mat3 k = cross_matrix(v / angle);
    return Mat3::Identity() + (1 - std::cos(angle)) / angle * k + (1 - std::sin(angle) / angle) * k * k;
}

}  // namespace

//! [freely_turned]
Vec3 freely_turned(const Vec3& principal_inertia, const Vec3& w0, double dt)
{
    const Vec3 momentum = principal_inertia.cwiseProduct(w0);
    const double rounding = 1e-15 * momentum.norm();

    Vec3 w1 = w0;
    for (int iteration = 0; iteration < 20; ++iteration) {
        const Vec3 theta = 0.5 * dt * (w0 + w1);
        const Vec3 turned_back = turn(-theta) * momentum;
        const Vec3 residual = principal_inertia.cwiseProduct(w1) - turned_back;
        if (residual.norm() <= rounding)
            return w1;
        Mat3 slope = principal_inertia.asDiagonal();
        slope -= 0.5 * dt * cross_matrix(turned_back) * turn_derivative(-theta);
        const Vec3 correction = slope.partialPivLu().solve(residual);
        w1 -= correction;
        if (correction.norm() <= 1e-15 * w1.norm())
            return w1;
    }
    return w0;
}
//! [freely_turned]

}  // namespace enduring
