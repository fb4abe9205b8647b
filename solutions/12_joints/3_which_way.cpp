#include "exercises/12_joints/3_which_way.hpp"

#include <cmath>

namespace enduring {

Swing step_by_start(const Swing& swing, double gravity, double dt)
{
    Swing after = swing;
    after.velocity.y() -= gravity * dt;
    after.place += dt * after.velocity;
    const double b = after.place.dot(swing.place), c = after.place.squaredNorm() - 1;
    const double s = -b + std::sqrt(b * b - c);
    after.place += s * swing.place;
    after.velocity += s / dt * swing.place;
    return after;
}

Swing step_by_end(const Swing& swing, double gravity, double dt)
{
    Swing after = swing;
    after.velocity.y() -= gravity * dt;
    after.place += dt * after.velocity;
    after.place.normalize();
    after.velocity = (after.place - swing.place) / dt;
    return after;
}

double energy(const Swing& swing, double gravity, double dt)
{
    const double kinetic = swing.velocity.squaredNorm() / 2;
    return kinetic + gravity * swing.place.y() - dt / 2 * gravity * swing.velocity.y();
}

EnergyLeft predicted(double omega, double dt)
{
    const double angle = omega * dt;
    const double next = std::atan2(std::sin(angle), 2 - std::cos(angle));
    return {1, std::pow(std::sin(next / 2) / std::sin(angle / 2), 2)};
}

}  // namespace enduring
