#include "exercises/07_implicit_contact/3_convex_friction.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

/// In the plane of the normal and the impulse the cone is an angle, and its mantle a ray.
struct InThePlane {
    double push, along;  ///< parts of the impulse
    Vec3 sideways;       ///< direction of the second part; any across the normal where there is none
    Vec3 ray;            ///< unit vector of the mantle
    double on_ray;       ///< the impulse's part along it
};

InThePlane in_the_plane(const Vec3& wanted, const Vec3& normal, double mu)
{
    InThePlane plane;
    plane.push = wanted.dot(normal);
    plane.sideways = normal.cross(wanted).cross(normal);
    plane.along = plane.sideways.norm();
    plane.sideways = plane.along > 0 ? Vec3(plane.sideways / plane.along) : normal.unitOrthogonal();
    plane.ray = std::cos(std::atan(mu)) * normal + std::sin(std::atan(mu)) * plane.sideways;
    plane.on_ray = plane.ray.dot(wanted);
    return plane;
}

}  // namespace

Vec3 nearest_in_cone(const Vec3& wanted, const Vec3& normal, double mu)
{
    const InThePlane plane = in_the_plane(wanted, normal, mu);
    if (plane.push >= 0 && plane.along <= mu * plane.push)
        return wanted;
    return std::max(0.0, plane.on_ray) * plane.ray;
}

Mat3 cone_derivative(const Vec3& wanted, const Vec3& normal, double mu)
{
    const InThePlane plane = in_the_plane(wanted, normal, mu);
    Mat3 derivative = Mat3::Zero();
    if (plane.push >= 0 && plane.along <= mu * plane.push)
        derivative.setIdentity();
    else if (plane.on_ray > 0) {
        // Along the ray it follows; around the axis it turns on a smaller circle; off the ray it stays.
        const double circle = plane.on_ray * plane.ray.dot(plane.sideways);
        const Mat3 off = normal * normal.transpose() + plane.sideways * plane.sideways.transpose();
        derivative = plane.ray * plane.ray.transpose() + circle / plane.along * (Mat3::Identity() - off);
    }
    return derivative;
}

ConvexAnswer convex_answer(const PairLaw& pair, const Vec3& velocity, double dt)
{
    const double mass = pair.stiffness * dt * dt;
    const Vec3 wanted = -mass * (velocity + (pair.depth_t0 * pair.normal + pair.stretch) / dt);
    ConvexAnswer made;
    made.impulse = nearest_in_cone(wanted, pair.normal, pair.mu);
    made.hessian = mass * cone_derivative(wanted, pair.normal, pair.mu);
    made.potential = 0.5 * made.impulse.dot(made.impulse) / mass;
    return made;
}

double depth_of_sliding(double load, double stiffness, double mu, double speed, double dt)
{
    // The wanted impulse whose nearest is load dt (1, mu): off the mantle by k dt^2 speed along the
    // surface, so by mu times as much less along the normal.
    const double push = load * dt - mu * stiffness * dt * dt * speed;
    return -push / (stiffness * dt);
}

}  // namespace enduring
