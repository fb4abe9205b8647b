// The turn by bisection, in the plane of complex numbers.
#include "exercises/07_implicit_contact/7_levers.hpp"

#include <complex>

namespace enduring {
namespace {

using Complex = std::complex<double>;

Complex number_of(const Eigen::Vector2d& vector) { return {vector.x(), vector.y()}; }

/// How far along its path a vertex is that has been at 1, from the centre.
Complex path(double turn, double tau) { return 1 - tau + tau * std::polar(1.0, turn); }

double moment(const Complex& lever, const Complex& impulse) { return std::imag(std::conj(lever) * impulse); }

/// The turn at which `made` is the turn itself. It differs from the free turn by less than 1, and grows by
/// less than its argument.
template <class Made>
double where_it_is_made(double free, const Made& made)
{
    double low = free - 1, high = free + 1;
    for (int halving = 0; halving < 100; ++halving) {
        const double between = (low + high) / 2;
        (made(between) > between ? low : high) = between;
    }
    return (low + high) / 2;
}

}  // namespace

Eigen::Vector2d lever_at(const Eigen::Vector2d& vertex, double turn, double tau)
{
    const Complex lever = number_of(vertex) * path(turn, tau);
    return {lever.real(), lever.imag()};
}

double turn_found(const PlaneBody& body, const std::vector<VertexPush>& pushes, double tau, double dt)
{
    // all vertices turn by the same angle, so their impulses add up in the frame of the body
    Complex sum = 0;
    for (const VertexPush& push : pushes)
        sum += std::conj(number_of(push.vertex)) * number_of(push.impulse);
    return where_it_is_made(dt * body.spin, [&](double turn) {
        return dt * (body.spin + moment(path(turn, tau), sum) / body.inertia);
    });
}

Eigen::Vector2d lever_of_the_lowest(const Wheel& wheel, double turn, double tau)
{
    const Complex lever = Complex(0, -wheel.radius) * path(-turn, 1 - tau);
    return {lever.real(), lever.imag()};
}

double wheel_turn(const Wheel& wheel, const Eigen::Vector2d& impulse, double tau, double dt)
{
    return where_it_is_made(dt * wheel.body.spin, [&](double turn) {
        const Complex lever = number_of(lever_of_the_lowest(wheel, turn, tau));
        return dt * (wheel.body.spin + moment(lever, number_of(impulse)) / wheel.body.inertia);
    });
}

double rolled(const Wheel& wheel, double tau, int steps, double dt)
{
    const auto [mass, inertia, begin] = wheel.body;
    double spin = begin;
    for (int step = 0; step < steps; ++step) {
        double change = 0;
        for (int round = 0; round < 60; ++round) {
            const Complex lever = number_of(lever_of_the_lowest(wheel, dt * (spin + change), tau));
            const Complex floor(-mass * wheel.radius * change, mass * gravity * dt);
            change = moment(lever, floor) / inertia * 0.5 + change * 0.5;
        }
        spin += change;
    }
    return spin;
}

double predicted_loss(const Wheel& wheel, double tau, double dt)
{
    const double radius = wheel.radius, gyration = wheel.body.inertia / wheel.body.mass;
    return (1 - tau) * 2 * gravity * radius * dt * dt / (radius * radius + gyration);
}

}  // namespace enduring
