#include "chapters/11_exact_contact/force_memory.hpp"

#include "chapters/11_exact_contact/contact_sweeps.hpp"
#include "chapters/11_exact_contact/natural_map.hpp"
#include "chapters/11_exact_contact/spring_pass.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <utility>

namespace enduring {
namespace {

/// With these a problem is begun again where its passes bring nothing any more.
constexpr std::array other_h{1e6, 1e3, 1e9};

/// A pass that leaves more than this part of the error has brought little; one that leaves more than the
/// second, nothing.
constexpr double little = 0.3, nothing = 0.99;

//! [next_springs]
/// How stiff the springs of the next pass are. A pass that reached its answer and took little of the error
/// has springs that give too much. One that did not reach it has springs that are too stiff, and for some
/// passes none are as stiff.
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

/// Steps of Newton's method that so many operations are enough for.
int affordable_steps(const FrictionProblem& problem, const ExactSettings& settings)
{
    const double of_step = operations_of_newton_step(problem, problem.response.rows());
    return static_cast<int>(std::min<double>(settings.max_newton_steps, settings.max_operations / of_step));
}

bool has_budget(const ExactSolution& best, int most_steps, const ExactSettings& settings)
{
    return best.error > settings.tolerance && best.newton_steps < most_steps &&
           static_cast<int>(best.errors.size()) < settings.max_passes;
}

//! [passes]
/// Passes from the best answer on, with springs that begin with this h, until nothing is brought any more.
void improve(const FrictionProblem& problem, const ExactSettings& settings, double h, ExactSolution& best)
{
    SpringChoice springs(h);
    SpringPass pass{problem, felt_masses(problem), h, best.impulses};
    double before = best.error;
    const int most_steps = affordable_steps(problem, settings);
    for (int idle = 0; idle < settings.max_idle_passes && has_budget(best, most_steps, settings);) {
        if (!settings.keeps_h)
            pass.h = springs.h();
        const PassAnswer answer = solve_pass(
            pass, std::min(settings.max_steps_of_pass, most_steps - best.newton_steps));
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

//! [begin_again]
/// Passes from these impulses on, and again with another h where they bring nothing any more. Where there is
/// not enough memory for them, the impulses stay as they are.
void improve_with_each_h(const FrictionProblem& problem, const ExactSettings& settings, ExactSolution& best)
{
    try {
        improve(problem, settings,
                settings.keeps_h ? settings.h : std::clamp(settings.h, softest_h, stiffest_h), best);
        for (const double h : other_h)
            if (!settings.keeps_h)
                improve(problem, settings, h, best);
    } catch (const std::bad_alloc&) {  // a factor that does not fit: what there is stays
    }
}
//! [begin_again]

/// From where sweeps end, with a part of all passes and steps: what is hard takes another path from there,
/// not a shorter one.
ExactSolution from_sweeps(const FrictionProblem& problem, ExactSettings settings)
{
    constexpr int part = 4;
    settings.max_passes /= part;
    settings.max_newton_steps /= part;
    SweepAnswer swept = sweep_contacts(problem, settings.tolerance);
    ExactSolution best;
    best.impulses = std::move(swept.impulses);
    best.error = swept.error;
    best.sweeps = swept.sweeps;
    improve_with_each_h(problem, settings, best);
    return best;
}

ExactSolution from_nothing(const FrictionProblem& problem, const ExactSettings& settings)
{
    ExactSolution best;
    best.impulses = Eigen::VectorXd::Zero(problem.free_velocity.size());
    best.error = natural_map_error(problem, best.impulses);
    improve_with_each_h(problem, settings, best);
    return best;
}

/// The better one of two, with what both have cost.
ExactSolution better(ExactSolution first, ExactSolution second)
{
    first.errors.insert(first.errors.end(), second.errors.begin(), second.errors.end());
    first.steps.insert(first.steps.end(), second.steps.begin(), second.steps.end());
    first.newton_steps += second.newton_steps;
    if (second.error < first.error) {
        first.error = second.error;
        first.impulses = std::move(second.impulses);
    }
    return first;
}

}  // namespace

//! [solve_exactly]
ExactSolution solve_exactly(const FrictionProblem& problem, const ExactSettings& settings)
{
    if (!settings.sweeps || settings.keeps_h)
        return from_nothing(problem, settings);
    ExactSolution swept = from_sweeps(problem, settings);
    if (swept.error <= settings.tolerance)
        return swept;
    return better(std::move(swept), from_nothing(problem, settings));
}
//! [solve_exactly]

}  // namespace enduring
