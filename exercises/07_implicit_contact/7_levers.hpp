#pragma once

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace enduring {

/// A rigid body in the plane: x to the right, y upwards, angles counterclockwise.
struct PlaneBody {
    double mass;     ///< [kg]
    double inertia;  ///< about its centre of mass [kg m^2]
    double spin;     ///< angular velocity before the impulses of the step [rad/s]
};

/// The impulse on one vertex in a step.
struct VertexPush {
    Eigen::Vector2d vertex;   ///< from the centre of mass, at the start of the step [m]
    Eigen::Vector2d impulse;  ///< [N s]
};

/// A body with a round rim about its centre of mass. Each point of the rim is a vertex.
struct Wheel {
    PlaneBody body;
    double radius;  ///< [m]
};

inline constexpr double gravity = 9.81;  ///< downwards [m/s^2]

/// Given: the vector turned by an angle [rad].
inline Eigen::Vector2d turned(const Eigen::Vector2d& vector, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * vector.x() - s * vector.y(), s * vector.x() + c * vector.y()};
}

/// Given: the angular momentum r x J of an impulse [N s] with this lever [m] [N m s].
inline double turning(const Eigen::Vector2d& lever, const Eigen::Vector2d& impulse)
{
    return lever.x() * impulse.y() - lever.y() * impulse.x();
}

/// The lever of a vertex [m]: the point at the part tau of the straight line from its position at the start
/// of the step to its position at the end.
/// @param vertex  from the centre of mass, at the start of the step [m]
/// @param turn    of the body in the whole step [rad]
/// @param tau     0: lever of the start, 1: of the end
Eigen::Vector2d lever_at(const Eigen::Vector2d& vertex, double turn, double tau);

/// The turn of the body in the step [rad]: dt times the angular velocity after all impulses, which act with
/// the levers of this turn. The iteration converges: dt times the sum of |vertex| |impulse| is at most 0.8
/// times the inertia.
double turn_found(const PlaneBody& body, const std::vector<VertexPush>& pushes, double tau, double dt);

/// The lever of the point of a wheel's rim that is lowest at the end of the step [m].
/// @param turn  of the wheel in the whole step [rad]
Eigen::Vector2d lever_of_the_lowest(const Wheel& wheel, double turn, double tau);

/// The turn of a wheel in a step [rad]. The floor pushes the point that is lowest at the end of this turn.
/// @param impulse  of the floor; dt times |impulse| times the radius is at most 0.8 times the inertia [N s]
double wheel_turn(const Wheel& wheel, const Eigen::Vector2d& impulse, double tau, double dt);

/// Angular velocity of a wheel that has rolled on level ground for this number of steps [rad/s]. In each step
/// the floor carries the weight at the point that is lowest at the end, and friction keeps the wheel rolling:
/// v = -radius * spin.
double rolled(const Wheel& wheel, double tau, int steps, double dt);

/// Your prediction: the part of its kinetic energy that a rolling wheel loses in one step.
double predicted_loss(const Wheel& wheel, double tau, double dt);

}  // namespace enduring
