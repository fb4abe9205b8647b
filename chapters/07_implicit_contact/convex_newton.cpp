#include "chapters/07_implicit_contact/contact_problem.hpp"
#include "chapters/07_implicit_contact/dual_friction.hpp"
#include "chapters/07_implicit_contact/newton_matrix.hpp"
#include "chapters/07_implicit_contact/weighted_impulse.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace enduring {

using Eigen::VectorXd;

namespace {

/// What a pair pushes along a direction, times its rate: what it takes from the objective's slope. Along a
/// straight change the depth and the stretch are straight, too, so a few numbers tell it everywhere.
class PairSlope {
public:
    PairSlope(const ContactProblem& problem, const PairRow& row, const Vec3& velocity, const Vec3& rate)
        : problem_(problem), row_(row), velocity_(velocity), rate_(rate),
          is_plain_(row.element < 0 && !row.law.has_grain && row.law.viscous == 0)
    {
        if (!is_plain_)
            return;
        const PairLaw& law = row.law;
        const double dt = problem.step.dt;
        normal_rate_ = law.normal.dot(rate);
        depth_t1_ = law.depth_t0 + dt * law.normal.dot(velocity);
        limit_ = std::max(0.0, law.mu * law.lagged_normal_impulse);
        if (limit_ == 0)
            return;
        const Vec3 spring = spring_impulse(law, velocity, problem.step),
                   change = -law.stiffness * dt * dt * (rate - normal_rate_ * law.normal);
        work_ = {spring.dot(rate), change.dot(rate)};
        squared_ = {spring.squaredNorm(), 2 * spring.dot(change), change.squaredNorm()};
    }

    double at(double t) const
    {
        if (!is_plain_)
            return rate_.dot(problem_.pushed_by(row_, velocity_ + t * rate_).total());
        const PairLaw& law = row_.law;
        const StepLaw& step = problem_.step;
        const double normal = normal_rate_ * weighted_impulse(law.depth_t0,
                                                              depth_t1_ + t * step.dt * normal_rate_,
                                                              step.centre, law.stiffness, step.dt)
                                                 .impulse;
        if (limit_ == 0)
            return normal;
        const double squared = squared_[0] + t * (squared_[1] + t * squared_[2]),
                     held = squared > limit_ * limit_ ? limit_ / std::sqrt(squared) : 1;
        return normal + held * (work_[0] + t * work_[1]);
    }

private:
    const ContactProblem& problem_;
    const PairRow& row_;
    const Vec3 &velocity_, &rate_;
    bool is_plain_;  ///< its friction is a spring that gives at its limit, the same in all directions
    double normal_rate_ = 0, depth_t1_ = 0, limit_ = 0;
    std::array<double, 2> work_{};     ///< of the spring along the surface: constant, and times t
    std::array<double, 3> squared_{};  ///< of its impulse: constant, times t, and times its square
};

//! [line_search]
/// How far to go along a direction: to where the slope of the objective,
/// which only rises, has nearly reached zero.
/// @param velocities, rates  of the pairs after the change and along the direction: they do not bend along
///     the way
/// @param impulses           that the pairs answer to the change
double step_length(const ContactProblem& problem, const VectorXd& change, const VectorXd& direction,
                   const std::vector<Vec3>& velocities, const std::vector<Vec3>& rates,
                   const VectorXd& impulses)
{
    const VectorXd mass_direction = times_mass(problem, direction);
    const double curvature = mass_direction.dot(direction);
    double slope_t0 = mass_direction.dot(change);
    std::vector<PairSlope> pairs;
    pairs.reserve(problem.rows.size());
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
        slope_t0 += rates[i].dot(problem.rows[i].acting);
        pairs.emplace_back(problem, problem.rows[i], velocities[i], rates[i]);
    }
    const auto slope_at = [&](double t) {
        double slope = slope_t0 + t * curvature;
        for (const PairSlope& pair : pairs)
            slope -= pair.at(t);
        return slope;
    };
    double low = 0, high = 1;
    double slope_low = slope_t0;
    for (std::size_t i = 0; i < rates.size(); ++i)
        slope_low -= rates[i].dot(impulses.segment<3>(static_cast<Eigen::Index>(3 * i)));
    double slope_high = slope_at(high);
    const double enough = 0.1 * std::abs(slope_low);
    while (slope_high < -enough && high < 64) {
        low = high;
        slope_low = slope_high;
        high *= 2;
        slope_high = slope_at(high);
    }
    if (std::abs(slope_high) <= enough)
        return high;
    for (int i = 0; i < 60; ++i) {
        // The secant's place, kept off the ends, where the slope bends sharply.
        const double secant = low - slope_low * (high - low) / (slope_high - slope_low),
                     margin = 0.1 * (high - low);
        const double middle = std::clamp(secant, low + margin, high - margin), slope = slope_at(middle);
        if (std::abs(slope) <= enough)
            return middle;
        (slope < 0 ? low : high) = middle;
        (slope < 0 ? slope_low : slope_high) = slope;
    }
    return low;
}
//! [line_search]

}  // namespace

//! [solve_convex]
ProblemSolution solve_convex(const ContactProblem& problem, NewtonMatrix& matrix,
                             const ProblemSolution& begin, double tolerance, double least_speed,
                             int max_steps)
{
    ProblemSolution solution{begin.change, begin.impulses};
    DualFriction friction(problem);
    for (;; ++solution.newton_steps) {
        const std::vector<Vec3> velocities = velocities_after(problem, solution.change);
        const Answers answers = answers_at(problem, velocities);
        const VectorXd gradient = times_mass(problem, solution.change) - answers.unbalanced;
        solution.residual = residual_from(problem, gradient, answers.total, least_speed);
        solution.converged = solution.residual <= tolerance;
        if (solution.converged || solution.newton_steps == max_steps)
            return solution;
        const VectorXd direction = matrix.solve(problem, friction.hessians(answers.pushes, velocities),
                                                -gradient);
        const std::vector<Vec3> rates = rates_of(problem, direction);
        friction.follow(velocities, rates);
        const double part = step_length(problem, solution.change, direction, velocities, rates,
                                        answers.impulses);
        solution.change += part * direction;
        solution.impulses += part * (matrix.tangent(answers.impulses, rates) - solution.impulses);
    }
}
//! [solve_convex]

}  // namespace enduring
