#include "chapters/11_exact_contact/relaxation.hpp"

#include "chapters/11_exact_contact/natural_map.hpp"

#include <cmath>

namespace enduring {

//! [projected_impulses]
Eigen::VectorXd projected_impulses(const FrictionProblem& problem, FrictionRule rule)
{
    constexpr int most = 100000;
    const double rho = 1 / problem.response.norm();
    Eigen::VectorXd impulses = Eigen::VectorXd::Zero(problem.free_velocity.size());
    for (int iteration = 0; iteration < most; ++iteration) {
        const Eigen::VectorXd before = impulses, velocities = contact_velocities(problem, impulses);
        for (int i = 0; i < problem.contacts(); ++i) {
            Vec3 velocity = numbers_of(problem, velocities, i);
            if (rule == FrictionRule::coulomb)
                velocity.x() += problem.mu[i] * std::hypot(velocity.y(), velocity.z());
            const Vec3 nearest = nearest_in_cone(numbers_of(problem, before, i) - rho * velocity,
                                                 problem.mu[i]);
            impulses.segment(problem.dimension * i, problem.dimension) = nearest.head(problem.dimension);
        }
        if ((impulses - before).norm() <= 1e-15 * impulses.norm())
            break;
    }
    return impulses;
}
//! [projected_impulses]

//! [after_step]
SlidingBlock after_step(const SlidingBlock& block, double mu, double dt, FrictionRule rule)
{
    FrictionProblem problem;
    problem.response.resize(3, 3);
    problem.response.setIdentity();
    problem.mu = Eigen::VectorXd::Constant(1, mu);
    problem.free_velocity = Vec3(block.gap / dt + block.rising - 9.81 * dt, block.speed, 0);
    const Vec3 after = contact_velocities(problem, projected_impulses(problem, rule));
    return {after.x() * dt, after.y(), after.x() - block.gap / dt};
}
//! [after_step]

//! [sliding_rod]
FrictionProblem sliding_rod(double angle, double mu, double speed, double fall)
{
    const double c = std::cos(angle), s = std::sin(angle);
    FrictionProblem problem;
    problem.dimension = 2;
    problem.response.resize(2, 2);
    problem.response.insert(0, 0) = 1 + 3 * c * c;
    problem.response.insert(0, 1) = problem.response.insert(1, 0) = 3 * s * c;
    problem.response.insert(1, 1) = 1 + 3 * s * s;
    problem.free_velocity = Eigen::Vector2d(-fall, speed);
    problem.mu = Eigen::VectorXd::Constant(1, mu);
    return problem;
}

double painleve_friction(double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return (1 + 3 * c * c) / (3 * s * c);
}
//! [sliding_rod]

}  // namespace enduring
