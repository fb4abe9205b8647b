#include "common/fem/polar_rotation.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>

namespace enduring {
namespace {

/// Below this ratio of det F to (|F| / sqrt 3)^3, which is 1 for a pure rotation,
/// Newton's iteration would be slow or find a reflection.
constexpr double safe_determinant = 0.1;

Mat3 by_singular_values(const Mat3& f)
{
    const Eigen::JacobiSVD<Mat3> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 u = svd.matrixU();
    const Mat3& v = svd.matrixV();
    if ((u.determinant() < 0) != (v.determinant() < 0))
        u.col(2) = -u.col(2);  // singular values come in descending order: the last is the thinnest direction
    return u * v.transpose();
}

Mat3 cofactors(const Mat3& r)
{
    Mat3 c;
    c << r.col(1).cross(r.col(2)), r.col(2).cross(r.col(0)), r.col(0).cross(r.col(1));
    return c;
}

/// R <- (R + R^-T) / 2 halves the logarithm of every singular value and
/// then converges quadratically (Higham 1986).
Mat3 by_newton(Mat3 r)
{
    for (int iteration = 0; iteration < 20; ++iteration) {
        const Mat3 c = cofactors(r);
        const Mat3 change = 0.5 * (c / r.col(0).dot(c.col(0)) - r);
        r += change;
        if (change.squaredNorm() < 1e-30)
            break;
    }
    return r;
}

}  // namespace

Mat3 polar_rotation(const Mat3& f)
{
    const double size = f.norm() / std::sqrt(3.0);
    if (f.determinant() > safe_determinant * size * size * size)
        return by_newton(f / size);
    return by_singular_values(f);
}

}  // namespace enduring
