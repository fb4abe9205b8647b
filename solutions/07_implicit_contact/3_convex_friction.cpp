#include "exercises/07_implicit_contact/3_convex_friction.hpp"

namespace enduring {

Vec3 nearest_in_cone(const Vec3& wanted, const Vec3& normal, double mu)
{
    const double push = normal.dot(wanted);
    const Vec3 along = wanted - push * normal;
    const double size = along.norm();
    if (mu * size <= -push)
        return Vec3::Zero();
    if (size <= mu * push)
        return wanted;
    const Vec3 mantle = normal + mu / size * along;
    return (push + mu * size) / (1 + mu * mu) * mantle;
}

Mat3 cone_derivative(const Vec3& wanted, const Vec3& normal, double mu)
{
    const double push = normal.dot(wanted);
    const Vec3 along = wanted - push * normal;
    const double size = along.norm();
    if (mu * size <= -push)
        return Mat3::Zero();
    if (size <= mu * push)
        return Mat3::Identity();
    const Vec3 direction = along / size, mantle = normal + mu * direction;
    const Vec3 across = normal.cross(direction);
    const double length = (push + mu * size) / (1 + mu * mu);
    return mantle * mantle.transpose() / (1 + mu * mu) + length * mu / size * across * across.transpose();
}

ConvexAnswer convex_answer(const PairLaw& pair, const Vec3& velocity, double dt)
{
    const double k = pair.stiffness;
    const Vec3 stretched = pair.depth_t0 * pair.normal + pair.stretch + dt * velocity;
    const Vec3 wanted = -k * dt * stretched, impulse = nearest_in_cone(wanted, pair.normal, pair.mu);
    return {impulse, k * dt * dt * cone_derivative(wanted, pair.normal, pair.mu),
            impulse.squaredNorm() / (2 * k * dt * dt)};
}

double depth_of_sliding(double load, double stiffness, double mu, double speed, double dt)
{
    return mu * dt * speed - load / stiffness;
}

}  // namespace enduring
