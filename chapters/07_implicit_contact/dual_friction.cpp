#include "chapters/07_implicit_contact/dual_friction.hpp"

namespace enduring {
namespace {

Vec3 within(double limit, const Vec3& friction)
{
    const double size = friction.norm();
    return size > limit ? Vec3(limit / size * friction) : friction;
}

//! [slip_stiffening]
/// By how much a pair is stiffer than its answer says: the answer takes its direction d twice where the
/// equation takes d and the guess once each, in both orders so that the sum stays symmetric.
Mat3 missing_stiffness(const PairRow& row, const PairPush& push, const Vec3& guess, const StepLaw& step)
{
    const double size = push.spring.norm();
    const Vec3 d = push.spring / size, short_of_it = d - guess / push.limit;
    const Mat3 once = d * short_of_it.transpose();
    return push.limit / size * row.law.stiffness * step.dt * step.dt * 0.5 * (once + once.transpose());
}
//! [slip_stiffening]

}  // namespace

DualFriction::DualFriction(const ContactProblem& problem) : problem_(problem)
{
    guesses_.reserve(problem.rows.size());
    for (const PairRow& row : problem.rows)
        guesses_.push_back(within(row.law.mu * row.law.lagged_normal_impulse,
                                  row.acting - row.law.normal.dot(row.acting) * row.law.normal));
}

std::vector<Mat3> DualFriction::hessians(const std::vector<PairPush>& pushes,
                                         const std::vector<Vec3>& velocities) const
{
    std::vector<Mat3> all;
    all.reserve(pushes.size());
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        const PairRow& row = problem_.rows[i];
        all.push_back(problem_.hessian_by(row, pushes[i], velocities[i]));
        if (pushes[i].slips && !row.law.has_grain)  // a guess follows a circle
            all.back() += missing_stiffness(row, pushes[i], guesses_[i], problem_.step);
    }
    return all;
}

//! [follow]
void DualFriction::follow(const std::vector<Vec3>& velocities, const std::vector<Vec3>& rates)
{
    for (std::size_t i = 0; i < problem_.rows.size(); ++i) {
        const PairRow& row = problem_.rows[i];
        const double limit = row.law.mu * row.law.lagged_normal_impulse;
        const Vec3 spring = spring_impulse(row.law, velocities[i], problem_.step),
                   then = spring_impulse(row.law, velocities[i] + rates[i], problem_.step);
        const double size = spring.norm();
        Vec3& guess = guesses_[i];
        guess = within(limit, size > limit
                                  ? Vec3((limit * then - spring.dot(then - spring) / size * guess) / size)
                                  : then);
    }
}
//! [follow]

}  // namespace enduring
