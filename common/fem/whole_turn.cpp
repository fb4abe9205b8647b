#include "common/fem/whole_turn.hpp"

#include "common/fem/mass_matrix.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>

namespace enduring {
namespace {

Vec3 sum_of_products(const NodalVectors& a, const NodalVectors& b)
{
    Vec3 sum = Vec3::Zero();
    for (Eigen::Index n = 0; n < a.cols(); ++n)
        sum += Vec3(a.col(n)).cross(Vec3(b.col(n)));
    return sum;
}

}  // namespace

WholeTurn::WholeTurn(const NodalVectors& positions, const Eigen::SparseMatrix<double>& mass_matrix)
{
    const Eigen::VectorXd masses = lumped_masses(mass_matrix);
    const Vec3 centre = positions * masses / masses.sum();
    levers_ = positions.colwise() - centre;
    mass_levers_ = levers_ * mass_matrix;
    const Mat3 second = levers_ * mass_levers_.transpose();
    const Mat3 inertia = second.trace() * Mat3::Identity() - second;
    inverse_inertia_ = inertia.completeOrthogonalDecomposition().pseudoInverse();
}

Vec3 WholeTurn::angular_momentum(const NodalVectors& v) const { return sum_of_products(mass_levers_, v); }

Vec3 WholeTurn::torque(const NodalVectors& forces) const { return sum_of_products(levers_, forces); }

void WholeTurn::add_turn(const Vec3& angular_momentum, NodalVectors& v) const
{
    const Vec3 omega = inverse_inertia_ * angular_momentum;
    for (Eigen::Index n = 0; n < v.cols(); ++n)
        v.col(n) += omega.cross(Vec3(levers_.col(n)));
}

void WholeTurn::remove_torque(NodalVectors& forces) const
{
    const Vec3 omega = inverse_inertia_ * torque(forces);
    for (Eigen::Index n = 0; n < forces.cols(); ++n)
        forces.col(n) -= omega.cross(Vec3(mass_levers_.col(n)));
}

NodalVectors WholeTurn::turn_about(int axis) const
{
    return -levers_.colwise().cross(Vec3(Vec3::Unit(axis)));
}

NodalVectors WholeTurn::share_of_turn(int axis) const
{
    return -mass_levers_.colwise().cross(Vec3(inverse_inertia_.col(axis)));
}

}  // namespace enduring
