// By least squares: of all weights that satisfy the four conditions, the affine ones
// make the sum of w^2/m least. With u = w / sqrt(m) that is the shortest solution of
// four equations for as many unknowns as there are nodes.
#include "exercises/03_penalty_impulses/3_shared_push.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace enduring {

std::vector<double> spread_weights(const Patch& patch, const Vec3& p)
{
    const auto count = static_cast<Eigen::Index>(patch.positions.size());
    Eigen::Matrix4Xd conditions(4, count);
    Eigen::VectorXd roots(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        roots[i] = std::sqrt(patch.masses[at]);
        conditions(0, i) = roots[i];
        conditions.col(i).tail<3>() = roots[i] * (patch.positions[at] - p);
    }
    const Eigen::VectorXd shortest =
        conditions.completeOrthogonalDecomposition().solve(Eigen::Vector4d::UnitX());
    const Eigen::VectorXd weights = roots.cwiseProduct(shortest);
    return {weights.data(), weights.data() + count};
}

void push_patch(Patch& patch, const std::vector<double>& weights, const Vec3& impulse)
{
    for (std::size_t i = 0; i < patch.velocities.size(); ++i)
        patch.velocities[i] += impulse * (weights[i] / patch.masses[i]);
}

/// A unit impulse along x, and the speed that it gives the weighted point.
double effective_mass(const Patch& patch, const std::vector<double>& weights)
{
    Patch pushed{patch.positions, patch.masses, std::vector<Vec3>(patch.positions.size(), Vec3::Zero())};
    push_patch(pushed, weights, Vec3::UnitX());
    double speed = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        speed += weights[i] * pushed.velocities[i].x();
    return 1 / speed;
}

double longest_step(const Patch& patch, const std::vector<double>& weights, double k)
{
    return std::sqrt(2 * effective_mass(patch, weights) / k);
}

}  // namespace enduring
