#include "chapters/07_implicit_contact/viscous_friction.hpp"

namespace enduring {

//! [film]
Vec3 film_impulse(const PairLaw& pair, const Vec3& velocity)
{
    const Vec3 slip = velocity - pair.normal.dot(velocity) * pair.normal;
    return -pair.viscous * pair.lagged_normal_impulse * slip;
}

Mat3 film_hessian(const PairLaw& pair)
{
    return pair.viscous * pair.lagged_normal_impulse *
           (Mat3::Identity() - pair.normal * pair.normal.transpose());
}
//! [film]

Vec3 stretch_without_film(const Vec3& stretch, double most)
{
    const double length = stretch.norm();
    return length > most ? Vec3(most / length * stretch) : stretch;
}

}  // namespace enduring
