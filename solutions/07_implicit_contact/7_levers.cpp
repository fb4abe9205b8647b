#include "exercises/07_implicit_contact/7_levers.hpp"

namespace enduring {

Eigen::Vector2d lever_at(const Eigen::Vector2d& vertex, double turn, double tau)
{
    return (1 - tau) * vertex + tau * turned(vertex, turn);
}

double turn_found(const PlaneBody& body, const std::vector<VertexPush>& pushes, double tau, double dt)
{
    double turn = dt * body.spin;
    for (int round = 0; round < 200; ++round) {
        double momentum = body.inertia * body.spin;
        for (const VertexPush& push : pushes)
            momentum += turning(lever_at(push.vertex, turn, tau), push.impulse);
        turn = dt * momentum / body.inertia;
    }
    return turn;
}

Eigen::Vector2d lever_of_the_lowest(const Wheel& wheel, double turn, double tau)
{
    const Eigen::Vector2d at_start = turned({0, -wheel.radius}, -turn);
    return lever_at(at_start, turn, tau);
}

double wheel_turn(const Wheel& wheel, const Eigen::Vector2d& impulse, double tau, double dt)
{
    double turn = dt * wheel.body.spin;
    for (int round = 0; round < 200; ++round) {
        const double gained = turning(lever_of_the_lowest(wheel, turn, tau), impulse) / wheel.body.inertia;
        turn = dt * (wheel.body.spin + gained);
    }
    return turn;
}

double rolled(const Wheel& wheel, double tau, int steps, double dt)
{
    const auto [mass, inertia, begin] = wheel.body;
    const double normal = mass * gravity * dt;
    double spin = begin;
    for (int step = 0; step < steps; ++step) {
        double change = 0;
        for (int round = 0; round < 20; ++round) {
            const Eigen::Vector2d lever = lever_of_the_lowest(wheel, dt * (spin + change), tau);
            change = lever.x() * normal / (inertia - mass * wheel.radius * lever.y());
        }
        spin += change;
    }
    return spin;
}

double predicted_loss(const Wheel& wheel, double tau, double dt)
{
    const double weight = wheel.body.mass * gravity,
                 rolling = wheel.body.inertia + wheel.body.mass * wheel.radius * wheel.radius;
    return 2 * (1 - tau) * weight * wheel.radius * dt * dt / rolling;
}

}  // namespace enduring
