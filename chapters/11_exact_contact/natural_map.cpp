#include "chapters/11_exact_contact/natural_map.hpp"

#include <cmath>

namespace enduring {

//! [nearest_in_cone]
Vec3 nearest_in_cone(const Vec3& impulse, double mu)
{
    const double normal = impulse.x(), along = std::hypot(impulse.y(), impulse.z());
    if (along <= mu * normal)
        return impulse;
    if (mu * along <= -normal)  // in the cone of all that is nearest to the tip
        return Vec3::Zero();
    const double nearest = (normal + mu * along) / (1 + mu * mu);  // along the cone's side
    return {nearest, mu * nearest / along * impulse.y(), mu * nearest / along * impulse.z()};
}
//! [nearest_in_cone]

//! [natural_map]
Vec3 natural_map(const Vec3& impulse, const Vec3& velocity, double mu)
{
    const double slip = std::hypot(velocity.y(), velocity.z());
    const Vec3 lifted = velocity + mu * slip * Vec3::UnitX();
    return impulse - nearest_in_cone(impulse - lifted, mu);
}
//! [natural_map]

Vec3 numbers_of(const FrictionProblem& problem, const Eigen::VectorXd& all, int contact)
{
    Vec3 numbers = Vec3::Zero();
    numbers.head(problem.dimension) = all.segment(problem.dimension * contact, problem.dimension);
    return numbers;
}

double natural_map_error(const FrictionProblem& problem, const Eigen::VectorXd& impulses)
{
    const Eigen::VectorXd velocities = contact_velocities(problem, impulses);
    double sum = 0;
    for (int i = 0; i < problem.contacts(); ++i)
        sum += natural_map(numbers_of(problem, impulses, i), numbers_of(problem, velocities, i),
                           problem.mu[i])
                   .squaredNorm();
    const double scale = problem.free_velocity.norm();
    return std::sqrt(sum) / (scale > 0 ? scale : 1);
}

}  // namespace enduring
