#include "chapters/07_implicit_contact/restitution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace enduring {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

//! [reflection_limits]
struct ReflectionLimits {
    /// Of the fastest approach: what counts as none. A tenth: more sweeps. Ten times: a millionth of the
    /// speed stays, and the next step answers it.
    double still = 1e-7;
    /// Sweeps over the pairs that approach together. A line of n pairs takes about n^2 of them. A tenth: long
    /// lines are not stopped at once, but reflected all the same. Ten times: nothing is gained.
    int max_sweeps = 1000;
    /// Reflections of one impact. A line of n balls takes n. A tenth: the shock of a line of a hundred stops
    /// midway. Ten times: time only.
    int max_reflections = 1000;
};
constexpr ReflectionLimits reflection_limits;
//! [reflection_limits]

/// Projected Gauss-Seidel over some of the pairs.
VectorXd impulses_that_stop(const std::vector<Eigen::Index>& pairs, const MatrixXd& response,
                            const VectorXd& velocities, double still)
{
    VectorXd impulses = VectorXd::Zero(velocities.size());
    VectorXd after = velocities;
    for (int sweep = 0; sweep < reflection_limits.max_sweeps; ++sweep) {
        double largest = 0;
        for (const Eigen::Index pair : pairs) {
            const double own = response(pair, pair);
            if (!(own > 0))
                continue;
            const double change = std::max(-impulses[pair], -after[pair] / own);
            impulses[pair] += change;
            after += change * response.col(pair);
            largest = std::max(largest, std::abs(change) * own);
        }
        if (largest <= still)
            break;
    }
    return impulses;
}

/// What counts as no approach [m/s].
double stillness(const VectorXd& velocities)
{
    return velocities.size() == 0 ? 0 : reflection_limits.still * std::max(0.0, -velocities.minCoeff());
}

std::vector<Eigen::Index> approaching(const VectorXd& velocities, double still)
{
    std::vector<Eigen::Index> pairs;
    pairs.reserve(static_cast<std::size_t>(velocities.size()));
    for (Eigen::Index i = 0; i < velocities.size(); ++i)
        if (velocities[i] < -still)
            pairs.push_back(i);
    return pairs;
}

}  // namespace

VectorXd stopping_impulses(const MatrixXd& response, const VectorXd& velocities)
{
    std::vector<Eigen::Index> all(static_cast<std::size_t>(velocities.size()));
    std::iota(all.begin(), all.end(), 0);
    return impulses_that_stop(all, response, velocities, 1e-2 * stillness(velocities));
}

//! [reflect]
VectorXd reflecting_impulses(const MatrixXd& response, const VectorXd& velocities)
{
    const double still = stillness(velocities);
    VectorXd sum = VectorXd::Zero(velocities.size()), now = velocities;
    for (int n = 0; n < reflection_limits.max_reflections; ++n) {
        const std::vector<Eigen::Index> pairs = approaching(now, still);
        if (pairs.empty())
            break;
        const VectorXd stopping = impulses_that_stop(pairs, response, now, 1e-2 * still);
        const VectorXd change = response * stopping;
        const double curvature = stopping.dot(change);
        if (!(curvature > 0))
            break;
        // twice, where they stop the pairs; and in any case the multiple that keeps the kinetic energy
        const double twice = -2 * stopping.dot(now) / curvature;
        sum += twice * stopping;
        now += twice * change;
    }
    return sum;
}
//! [reflect]

double allowed_part(double slope, double curvature, double allowed)
{
    if (slope + curvature / 2 <= allowed)
        return 1;
    if (!(allowed >= 0))
        return 0;
    const double root = std::sqrt(slope * slope + 2 * curvature * allowed);
    // two forms of one number: neither subtracts what may be equal
    return std::clamp(slope <= 0 ? (root - slope) / curvature : 2 * allowed / (slope + root), 0.0, 1.0);
}

}  // namespace enduring
