#include "exercises/07_implicit_contact/7_levers.hpp"
#include "exercises/not_implemented_yet.hpp"

namespace enduring {

Eigen::Vector2d lever_at(const Eigen::Vector2d& vertex, double turn, double tau)
{
    not_implemented_yet("7.7");
}

double turn_found(const PlaneBody& body, const std::vector<VertexPush>& pushes, double tau, double dt)
{
    not_implemented_yet("7.7");
}

Eigen::Vector2d lever_of_the_lowest(const Wheel& wheel, double turn, double tau)
{
    not_implemented_yet("7.7");
}

double wheel_turn(const Wheel& wheel, const Eigen::Vector2d& impulse, double tau, double dt)
{
    not_implemented_yet("7.7");
}

double rolled(const Wheel& wheel, double tau, int steps, double dt)
{
    not_implemented_yet("7.7");
}

double predicted_loss(const Wheel& wheel, double tau, double dt)
{
    not_implemented_yet("7.7");
}

}  // namespace enduring
