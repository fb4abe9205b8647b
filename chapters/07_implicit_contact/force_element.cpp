#include "chapters/07_implicit_contact/force_element.hpp"

#include <Eigen/Core>

namespace enduring {

//! [element]
namespace {

/// What the two lines of a plane push together, by the lengths along them.
Eigen::Vector2d round_impulse(const ElementLaw& law, const Eigen::Vector2d& along)
{
    const Eigen::Vector2d free = -law.lines[0].slope * along;
    const double size = free.norm(), most = law.lines[0].high;
    return size > most ? Eigen::Vector2d(most / size * free) : free;
}

/// Minus its derivative: beyond its bound a plane gives no more along the push, and turns it.
Eigen::Matrix2d round_hessian(const ElementLaw& law, const Eigen::Vector2d& along)
{
    const double slope = law.lines[0].slope, size = slope * along.norm(), most = law.lines[0].high;
    if (size <= most)
        return slope * Eigen::Matrix2d::Identity();
    const Eigen::Vector2d direction = along.normalized();
    return most / size * slope * (Eigen::Matrix2d::Identity() - direction * direction.transpose());
}

}  // namespace

Vec3 ElementLaw::impulse(const Vec3& velocity) const
{
    Vec3 sum = Vec3::Zero();
    if (is_round)
        sum = axes.leftCols<2>() * round_impulse(*this, axes.leftCols<2>().transpose() * velocity);
    for (int i = is_round ? 2 : 0; i < 3; ++i)
        sum += lines[static_cast<std::size_t>(i)].impulse(axes.col(i).dot(velocity)) * axes.col(i);
    return sum;
}

Mat3 ElementLaw::hessian(const Vec3& velocity) const
{
    Mat3 sum = Mat3::Zero();
    if (is_round)
        sum = axes.leftCols<2>() * round_hessian(*this, axes.leftCols<2>().transpose() * velocity) *
              axes.leftCols<2>().transpose();
    for (int i = is_round ? 2 : 0; i < 3; ++i)
        sum += lines[static_cast<std::size_t>(i)].slope_at(axes.col(i).dot(velocity)) * axes.col(i) *
               axes.col(i).transpose();
    return sum;
}
//! [element]

}  // namespace enduring
