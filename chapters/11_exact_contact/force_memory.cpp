#include "chapters/11_exact_contact/force_memory.hpp"

#include "chapters/11_exact_contact/natural_map.hpp"
#include "chapters/11_exact_contact/spring_pass.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace enduring {
namespace {

/// With these a problem is begun again where its passes bring nothing any more.
constexpr std::array other_h{1e6, 1e3, 1e9};

/// A pass that leaves more than this part of the error has brought little; one that leaves more than the second, nothing.
constexpr double little = 0.3, nothing = 0.99;

//! [next_springs]
/// How stiff the springs of the next pass are. A pass that reached its answer and took little of the error has springs that give
/// too much. One that did not reach it has springs that are too stiff, and for some passes none are as stiff.
class SpringChoice {
public:
    explicit SpringChoice(double h) : h_(std::clamp(h, softest_h, stiffest_h)) {}
    double h() const { return h_; }
    void follow(bool reached, double error, double error_before)
    {
        if (!reached)
            too_stiff_ = h_;
        const double wanted = error > little * error_before ? step * h_ : h_;
        h_ = std::clamp(std::min(wanted, too_stiff_ / step), softest_h, stiffest_h);
        too_stiff_ *= forgotten;  // the next passes begin elsewhere, where it may not be
    }

private:
    static constexpr double step = 10, forgotten = 1.5;
    double h_, too_stiff_ = std::numeric_limits<double>::infinity();
};
//! [next_springs]

bool has_budget(const ExactSolution& best, const ExactSettings& settings)
{
    return best.error > settings.tolerance && best.newton_steps < settings.max_newton_steps &&
           static_cast<int>(best.errors.size()) < settings.max_passes;
}

//! [passes]
/// Passes from the best answer on, with springs that begin with this h, until nothing is brought any more.
void improve(const FrictionProblem& problem, const ExactSettings& settings, double h, ExactSolution& best)
{
    SpringChoice springs(h);
    SpringPass pass{problem, felt_masses(problem), h, best.impulses};
    double before = best.error;
    for (int idle = 0; idle < settings.max_idle_passes && has_budget(best, settings);) {
        if (!settings.keeps_h)
            pass.h = springs.h();
        const PassAnswer answer = solve_pass(
            pass, std::min(settings.max_steps_of_pass, settings.max_newton_steps - best.newton_steps));
        const double error = natural_map_error(problem, answer.impulses);
        idle = error < nothing * best.error ? 0 : idle + 1;
        if (settings.keeps_h || answer.reached || idle == 0)
            pass.begin = answer.impulses;  // what it pushed is what it remembers
        springs.follow(answer.reached, error, before);
        before = error;
        best.errors.push_back(error);
        best.steps.push_back(answer.newton_steps);
        best.newton_steps += answer.newton_steps;
        if (error < best.error) {
            best.error = error;
            best.impulses = answer.impulses;
        }
    }
}
//! [passes]

}  // namespace

//! [solve_exactly]
ExactSolution solve_exactly(const FrictionProblem& problem, const ExactSettings& settings)
{
    ExactSolution best;
    best.impulses = Eigen::VectorXd::Zero(problem.free_velocity.size());
    best.error = natural_map_error(problem, best.impulses);
    improve(problem, settings, settings.keeps_h ? settings.h : std::clamp(settings.h, softest_h, stiffest_h),
            best);
    for (const double h : other_h)
        if (!settings.keeps_h)
            improve(problem, settings, h, best);
    return best;
}
//! [solve_exactly]

}  // namespace enduring
