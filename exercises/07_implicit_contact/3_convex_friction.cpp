#include "exercises/07_implicit_contact/3_convex_friction.hpp"
#include "exercises/not_implemented_yet.hpp"

namespace enduring {

Vec3 nearest_in_cone(const Vec3& wanted, const Vec3& normal, double mu)
{
    not_implemented_yet("7.3");
}

Mat3 cone_derivative(const Vec3& wanted, const Vec3& normal, double mu)
{
    not_implemented_yet("7.3");
}

ConvexAnswer convex_answer(const PairLaw& pair, const Vec3& velocity, double dt)
{
    not_implemented_yet("7.3");
}

double depth_of_sliding(double load, double stiffness, double mu, double speed, double dt)
{
    not_implemented_yet("7.3");
}

}  // namespace enduring
