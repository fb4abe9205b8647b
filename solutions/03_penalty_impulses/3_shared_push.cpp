#include "exercises/03_penalty_impulses/3_shared_push.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace enduring {

using Vec4 = Eigen::Vector4d;
using Mat4 = Eigen::Matrix4d;

std::vector<double> spread_weights(const Patch& patch, const Vec3& p)
{
    // weight = mass (a + b . r) with r = x - p; sum of weights 1 and sum of
    // weights times r 0 are four equations for a, b.
    Mat4 equations = Mat4::Zero();
    std::vector<Vec4> rows;
    for (std::size_t i = 0; i < patch.positions.size(); ++i) {
        const Vec3 r = patch.positions[i] - p;
        rows.emplace_back(1, r.x(), r.y(), r.z());
        equations += patch.masses[i] * rows[i] * rows[i].transpose();
    }
    // Nodes in one plane say nothing about b across it: the smallest solution takes none.
    const Vec4 field = equations.completeOrthogonalDecomposition().solve(Vec4::UnitX());
    std::vector<double> weights;
    for (std::size_t i = 0; i < rows.size(); ++i)
        weights.push_back(patch.masses[i] * field.dot(rows[i]));
    return weights;
}

void push_patch(Patch& patch, const std::vector<double>& weights, const Vec3& impulse)
{
    for (std::size_t i = 0; i < weights.size(); ++i)
        patch.velocities[i] += weights[i] / patch.masses[i] * impulse;
}

double effective_mass(const Patch& patch, const std::vector<double>& weights)
{
    double answer = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        answer += weights[i] * weights[i] / patch.masses[i];
    return 1 / answer;
}

double longest_step(const Patch& patch, const std::vector<double>& weights, double k)
{
    return std::sqrt(2 * effective_mass(patch, weights) / k);
}

}  // namespace enduring
