#include "chapters/07_implicit_contact/force_element.hpp"

namespace enduring {

//! [element]
Vec3 ElementLaw::impulse(const Vec3& velocity) const
{
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 3; ++i)
        sum += lines[static_cast<std::size_t>(i)].impulse(axes.col(i).dot(velocity)) * axes.col(i);
    return sum;
}

Mat3 ElementLaw::hessian(const Vec3& velocity) const
{
    Mat3 sum = Mat3::Zero();
    for (int i = 0; i < 3; ++i)
        sum += lines[static_cast<std::size_t>(i)].slope_at(axes.col(i).dot(velocity)) * axes.col(i) *
               axes.col(i).transpose();
    return sum;
}
//! [element]

}  // namespace enduring
