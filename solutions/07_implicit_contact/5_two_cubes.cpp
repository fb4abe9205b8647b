#include "exercises/07_implicit_contact/5_two_cubes.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

double potential_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt)
{
    const double k = pair.stiffness, pressed = std::min(0.0, pair.gap + dt * velocity.y());
    const double size = std::abs(pair.stretch + dt * velocity.x());
    const bool holds = k * dt * size <= limit;
    const double friction = holds ? k / 2 * size * size
                                  : limit / dt * size - limit * limit / (2 * k * dt * dt);
    return k / 2 * pressed * pressed + friction;
}

Eigen::Vector2d impulse_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt)
{
    const double k = pair.stiffness, wanted = -k * dt * (pair.stretch + dt * velocity.x());
    const double normal = -k * dt * std::min(0.0, pair.gap + dt * velocity.y());
    return {std::clamp(wanted, -limit, limit), normal};
}

Eigen::Matrix2d hessian_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt)
{
    const bool holds = pair.stiffness * dt * std::abs(pair.stretch + dt * velocity.x()) <= limit;
    const bool pressed = pair.gap + dt * velocity.y() < 0;
    return pair.stiffness * dt * dt * Eigen::Vector2d(holds, pressed).asDiagonal().toDenseMatrix();
}

Eigen::VectorXd gradient(const PileStep& step, const std::vector<double>& limits, const Eigen::VectorXd& v)
{
    Eigen::VectorXd sum = v - step.free;
    for (std::size_t i = 0; i < step.masses.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(2 * i);
        const Eigen::Vector2d impulse = impulse_of(step.pairs[i], velocity_of_pair(v, i), limits[i], step.dt);
        sum.segment<2>(row) = step.masses[i] * sum.segment<2>(row) - impulse;
        if (i > 0)
            sum.segment<2>(row - 2) += impulse;
    }
    return sum;
}

Eigen::VectorXd solved(const PileStep& step, const std::vector<double>& limits, const Eigen::VectorXd& begin)
{
    Eigen::VectorXd v = begin;
    for (int i = 0; i < 100; ++i) {
        const Eigen::VectorXd direction = -hessian(step, limits, v).ldlt().solve(gradient(step, limits, v));
        v += part_to_take(step, limits, v, direction) * direction;
    }
    return v;
}

PileMotion after_step(const PileStep& step)
{
    PileMotion motion{step.free, std::vector<double>(step.masses.size(), 0)};
    bool stays = false;
    for (int round = 0; round < 100 && !stays; ++round) {
        motion.velocities = solved(step, motion.limits, motion.velocities);
        stays = true;
        for (std::size_t i = 0; i < step.masses.size(); ++i) {
            const Eigen::Vector2d u = velocity_of_pair(motion.velocities, i);
            const double before = motion.limits[i];
            motion.limits[i] = step.pairs[i].mu * impulse_of(step.pairs[i], u, 0, step.dt).y();
            stays = stays && std::abs(motion.limits[i] - before) <= 1e-12 * before;
        }
    }
    return motion;
}

}  // namespace enduring
