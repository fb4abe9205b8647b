#include "common/fem/point_laws.hpp"

#include "common/fem/polar_rotation.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

using GradientVector = Eigen::Matrix<double, 9, 1>;

/// d det F / dF.
Mat3 determinant_gradient(const Mat3& f)
{
    Mat3 c;
    c << f.col(1).cross(f.col(2)), f.col(2).cross(f.col(0)), f.col(0).cross(f.col(1));
    return c;
}

/// F = U diag(s) V^T with two rotations, so that one s is negative where F is inverted.
struct Stretches {
    explicit Stretches(const Mat3& f)
    {
        const Eigen::JacobiSVD<Mat3> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
        u = svd.matrixU();
        v = svd.matrixV();
        s = svd.singularValues();
        for (Mat3* side : {&u, &v})
            if (side->determinant() < 0) {
                side->col(2) *= -1;
                s[2] *= -1;
            }
    }
    /// The gradient u_i v_j^T.
    GradientVector unit(int i, int j) const { return Mat3(u.col(i) * v.col(j).transpose()).reshaped(); }

    Mat3 u, v;
    Vec3 s;
};

/// The nearest matrix without negative eigenvalues.
Mat3 without_negative(const Mat3& symmetric)
{
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(symmetric);
    return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
           solver.eigenvectors().transpose();
}

}  // namespace

double CorotatedLaw::energy(const Mat3& f) const
{
    const Mat3 strain = polar_rotation(f).transpose() * f - Mat3::Identity();
    const double trace = strain.trace();
    return lame_.mu * strain.squaredNorm() + 0.5 * lame_.lambda * trace * trace;
}

Mat3 CorotatedLaw::stress(const Mat3& f) const
{
    const Mat3 r = polar_rotation(f);
    return 2 * lame_.mu * (f - r) + lame_.lambda * (r.transpose() * f - Mat3::Identity()).trace() * r;
}

//! [corotated_stiffness]
/// dF -> R (2 mu sym(R^T dF) + lambda tr(R^T dF)) = mu dF + mu R dF^T R + lambda (R : dF) R.
GradientMap CorotatedLaw::stiffness(const Mat3& f) const
{
    const Mat3 r = polar_rotation(f);
    GradientMap map = lame_.mu * GradientMap::Identity() +
                      lame_.lambda * r.reshaped() * r.reshaped().transpose();
    for (int j = 0; j < 3; ++j)
        for (int l = 0; l < 3; ++l)  // from row k of dF's column l to row i of column j: R_il R_kj
            map.block<3, 3>(3 * j, 3 * l) += lame_.mu * r.col(l) * r.col(j).transpose();
    return map;
}
//! [corotated_stiffness]

//! [reparametrised]
NeoHookeanLaw::NeoHookeanLaw(const LameConstants& lame)
    : lambda_(lame.lambda + 5 * lame.mu / 6), mu_(4 * lame.mu / 3), alpha_(1 + 3 * mu_ / (4 * lambda_))
{}
//! [reparametrised]

double NeoHookeanLaw::energy(const Mat3& f) const
{
    const double lengths = f.squaredNorm(), change = f.determinant() - alpha_;
    const double at_rest = 0.5 * lambda_ * (1 - alpha_) * (1 - alpha_);
    return 0.5 * mu_ * (lengths - 3 - std::log((lengths + 1) / 4)) + 0.5 * lambda_ * change * change -
           at_rest;
}

Mat3 NeoHookeanLaw::stress(const Mat3& f) const
{
    return mu_ * (1 - 1 / (f.squaredNorm() + 1)) * f +
           lambda_ * (f.determinant() - alpha_) * determinant_gradient(f);
}

//! [neo_hookean_stiffness]
/// Nine eigenvectors: three gradients stretch along the principal axes, and of the others each pair of axes
/// has one that shears and one that turns.
GradientMap NeoHookeanLaw::stiffness(const Mat3& f) const
{
    const Stretches principal(f);
    const Vec3& s = principal.s;
    const double lengths = s.squaredNorm() + 1, pressure = lambda_ * (s.prod() - alpha_);
    const double straight = mu_ * (1 - 1 / lengths);
    const Vec3 areas(s[1] * s[2], s[2] * s[0], s[0] * s[1]);

    Mat3 stretching = 2 * mu_ / (lengths * lengths) * s * s.transpose() +
                      lambda_ * areas * areas.transpose() + straight * Mat3::Identity();
    GradientMap map = GradientMap::Zero();
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        stretching(i, j) += pressure * s[k];
        stretching(j, i) += pressure * s[k];
        const GradientVector one = principal.unit(i, j), other = principal.unit(j, i);
        const GradientVector shear = one + other, turn = one - other;
        map += 0.5 * std::max(0.0, straight - pressure * s[k]) * shear * shear.transpose() +
               0.5 * std::max(0.0, straight + pressure * s[k]) * turn * turn.transpose();
    }
    Eigen::Matrix<double, 9, 3> axes;
    axes << principal.unit(0, 0), principal.unit(1, 1), principal.unit(2, 2);
    return map + axes * without_negative(stretching) * axes.transpose();
}
//! [neo_hookean_stiffness]

}  // namespace enduring
