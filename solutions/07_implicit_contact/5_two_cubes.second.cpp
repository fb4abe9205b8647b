#include "exercises/07_implicit_contact/5_two_cubes.hpp"

#include <cmath>

namespace enduring {

// The potential as the work of the impulse: a trapezium where the spring holds, and a rectangle beyond.
double potential_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt)
{
    const double depth = -pair.gap - dt * velocity.y(), stretch = std::abs(pair.stretch + dt * velocity.x());
    const double held = std::fmin(stretch, limit / (pair.stiffness * dt));
    return pair.stiffness * ((depth > 0 ? depth * depth / 2 : 0) + held * held / 2 + held * (stretch - held));
}

Eigen::Vector2d impulse_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt)
{
    const Eigen::Vector2d spring =
        pair.stiffness * dt * Eigen::Vector2d(pair.stretch + dt * velocity.x(), pair.gap + dt * velocity.y());
    const double part = std::abs(spring.x()) > limit ? limit / std::abs(spring.x()) : 1;
    return {-part * spring.x(), spring.y() < 0 ? -spring.y() : 0};
}

Eigen::Matrix2d hessian_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt)
{
    Eigen::Matrix2d result = Eigen::Matrix2d::Zero();
    if (pair.stiffness * std::abs(pair.stretch + dt * velocity.x()) < limit / dt)
        result(0, 0) = pair.stiffness * dt * dt;
    if (impulse_of(pair, velocity, limit, dt).y() > 0)
        result(1, 1) = pair.stiffness * dt * dt;
    return result;
}

// A row of J^T at a time: a cube gets the impulse below it, less the one above it.
Eigen::VectorXd gradient(const PileStep& step, const std::vector<double>& limits, const Eigen::VectorXd& v)
{
    Eigen::VectorXd result(v.size());
    const auto of_pair = [&](std::size_t i) -> Eigen::Vector2d {
        return i < step.pairs.size() ? impulse_of(step.pairs[i], velocity_of_pair(v, i), limits[i], step.dt)
                                     : Eigen::Vector2d(0, 0);
    };
    for (std::size_t i = 0; i < step.masses.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(2 * i);
        result.segment<2>(row) = step.masses[i] * (v - step.free).segment<2>(row) - of_pair(i) +
                                 of_pair(i + 1);
    }
    return result;
}

Eigen::VectorXd solved(const PileStep& step, const std::vector<double>& limits, const Eigen::VectorXd& begin)
{
    Eigen::VectorXd v = begin, direction = begin;
    for (int i = 0; i < 100 && direction.norm() > 0; ++i) {
        direction = hessian(step, limits, v).llt().solve(-gradient(step, limits, v));
        v += part_to_take(step, limits, v, direction) * direction;
    }
    return v;
}

// No normal impulse depends on friction here, so two rounds do.
PileMotion after_step(const PileStep& step)
{
    std::vector<double> limits(step.masses.size(), 0);
    const Eigen::VectorXd frictionless = solved(step, limits, step.free);
    for (std::size_t i = 0; i < limits.size(); ++i)
        limits[i] = step.pairs[i].mu *
                    impulse_of(step.pairs[i], velocity_of_pair(frictionless, i), 0, step.dt).y();
    return {solved(step, limits, frictionless), limits};
}

}  // namespace enduring
