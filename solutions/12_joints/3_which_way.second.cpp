#include "exercises/12_joints/3_which_way.hpp"

#include <cmath>

namespace enduring {
namespace {

Vec2 fallen(const Swing& swing, double gravity, double dt)
{
    Vec2 velocity = swing.velocity;
    velocity.y() -= gravity * dt;
    return velocity;
}

}  // namespace

/// Along the rod of the start and at right angles to it: what lies at right angles stays.
Swing step_by_start(const Swing& swing, double gravity, double dt)
{
    const Vec2 along = swing.place, beside(-along.y(), along.x()), velocity = fallen(swing, gravity, dt);
    const double side = dt * velocity.dot(beside);
    const Vec2 place = std::sqrt(1 - side * side) * along + side * beside;
    return {place, (place - swing.place) / dt};
}

Swing step_by_end(const Swing& swing, double gravity, double dt)
{
    Swing after;
    after.velocity = fallen(swing, gravity, dt);
    after.place = swing.place + dt * after.velocity;
    const double too_long = after.place.norm() - 1;
    const Vec2 out = after.place.normalized();
    after.place -= too_long * out;
    after.velocity -= too_long / dt * out;
    return after;
}

double energy(const Swing& swing, double gravity, double dt)
{
    const double kinetic = swing.velocity.dot(swing.velocity) / 2;
    return kinetic + gravity * (swing.place.y() - dt * swing.velocity.y() / 2);
}

/// By the steps themselves.
EnergyLeft predicted(double omega, double dt)
{
    const double angle = omega * dt;
    const Vec2 here(1, 0), last(std::cos(angle), -std::sin(angle));
    const Swing swing{here, (here - last) / dt};
    const double before = swing.velocity.squaredNorm();
    return {step_by_start(swing, 0, dt).velocity.squaredNorm() / before,
            step_by_end(swing, 0, dt).velocity.squaredNorm() / before};
}

}  // namespace enduring
