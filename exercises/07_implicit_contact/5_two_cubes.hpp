#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace enduring {

/// A pair between two cubes, or between a cube and the floor. Nothing turns, so it has two directions: along
/// the surface, and along the normal, upwards.
struct CubePair {
    double gap;        ///< at the start of the step, negative where the cubes overlap [m]
    double stiffness;  ///< k [N/m]
    double stretch;    ///< of its friction spring at the start of the step [m]
    double mu;
};

/// A step of a pile of cubes. Pair i is below cube i; below cube 0 is the floor. Vectors of velocities have
/// two numbers for each cube: along the surface, and upwards.
struct PileStep {
    std::vector<double> masses;   ///< [kg]
    std::vector<CubePair> pairs;  ///< one below each cube
    Eigen::VectorXd free;         ///< velocities without contact [m/s]
    double dt;                    ///< [s]
};

/// J v of one pair: the velocity of cube i relative to the body below [m/s].
inline Eigen::Vector2d velocity_of_pair(const Eigen::VectorXd& velocities, std::size_t pair)
{
    const auto row = static_cast<Eigen::Index>(2 * pair);
    return velocities.segment<2>(row) -
           (pair > 0 ? Eigen::Vector2d(velocities.segment<2>(row - 2)) : Eigen::Vector2d(0, 0));
}

/// Formulas 1 and 2: the sum of the potentials of the normal spring and of friction with a given limit [J].
/// @param velocity  of the pair [m/s]
double potential_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt);

/// Formula 3: the impulse on the upper cube, minus the slope of the potential [N s].
Eigen::Vector2d impulse_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt);

/// Formula 4: the contact Hessian, minus the derivative of the impulse [kg]. At a border that of either side.
Eigen::Matrix2d hessian_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt);

/// Given: what the step minimises, 1/2 (v - v*)^T A (v - v*) plus the potentials of all pairs [J].
inline double objective(const PileStep& step, const std::vector<double>& limits, const Eigen::VectorXd& v)
{
    double sum = 0;
    for (std::size_t i = 0; i < step.masses.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(2 * i);
        sum += step.masses[i] / 2 * (v - step.free).segment<2>(row).squaredNorm() +
               potential_of(step.pairs[i], velocity_of_pair(v, i), limits[i], step.dt);
    }
    return sum;
}

/// The slope of the objective: A (v - v*) minus the impulses of all pairs [N s]. A pair pushes the cube above
/// up, and the cube below down.
Eigen::VectorXd gradient(const PileStep& step, const std::vector<double>& limits, const Eigen::VectorXd& v);

/// Given: the Hessian of the objective, from A and the contact Hessians of all pairs [kg].
inline Eigen::MatrixXd hessian(const PileStep& step, const std::vector<double>& limits,
                               const Eigen::VectorXd& v)
{
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(v.size(), v.size());
    for (std::size_t i = 0; i < step.masses.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(2 * i);
        const Eigen::Matrix2d of_pair = hessian_of(step.pairs[i], velocity_of_pair(v, i), limits[i], step.dt);
        sum.block<2, 2>(row, row) += step.masses[i] * Eigen::Matrix2d::Identity() + of_pair;
        if (i > 0) {
            sum.block<2, 2>(row - 2, row - 2) += of_pair;
            sum.block<2, 2>(row, row - 2) -= of_pair;
            sum.block<2, 2>(row - 2, row) -= of_pair;
        }
    }
    return sum;
}

/// Given: the line search. The part of a direction to take: the whole if the slope at its end is less than a
/// tenth of that at its beginning, else a part found by bisection.
inline double part_to_take(const PileStep& step, const std::vector<double>& limits, const Eigen::VectorXd& v,
                           const Eigen::VectorXd& direction)
{
    if (direction.norm() <= 1e-14 * (1e-3 + v.norm()))
        return 1;  // rounding is all that is left
    const auto slope_at = [&](double part) {
        return gradient(step, limits, v + part * direction).dot(direction);
    };
    const double small = 0.1 * std::abs(slope_at(0));
    double low = 0, high = 1, part = 1;
    for (int i = 0; i < 60; ++i) {
        const double slope = slope_at(part);
        if (std::abs(slope) <= small || (part == 1 && slope < 0))
            return part;
        (slope < 0 ? low : high) = part;
        part = (low + high) / 2;
    }
    return part;
}

/// The velocities that minimise the objective, by Newton's method with a line search. 100 steps are enough.
/// @param begin  the first velocities of the iteration
Eigen::VectorXd solved(const PileStep& step, const std::vector<double>& limits, const Eigen::VectorXd& begin);

/// The result of a step.
struct PileMotion {
    Eigen::VectorXd velocities;  ///< at the end of the step
    std::vector<double> limits;  ///< of friction, mu times the normal impulse of this motion [N s]
};

/// Formula 5, beginning with limits of zero: solve the problem and take the limits from its normal impulses,
/// until no limit changes by more than 1e-12 of its value. At most 100 rounds.
PileMotion after_step(const PileStep& step);

}  // namespace enduring
