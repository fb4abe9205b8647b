#include "chapters/01_particle_plane/settling.hpp"

#include <algorithm>
#include <stdexcept>

namespace enduring {

std::vector<double> last_heights(const ParticleProblem& problem, const SettlingTest& test)
{
    ParticleState state = simulate({test.drop_height, 0}, problem, test.steps - test.watched);
    std::vector<double> heights;
    for (int i = 0; i < test.watched; ++i) {
        state = step(state, problem);
        heights.push_back(state.height);
    }
    return heights;
}

double last_swing(const ParticleProblem& problem, const SettlingTest& test)
{
    const std::vector<double> heights = last_heights(problem, test);
    const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
    return *highest - *lowest;
}

//! [settles]
bool settles(const ParticleProblem& problem, const SettlingTest& test)
{
    const double static_depth = problem.mass * problem.gravity / problem.stiffness;
    return last_swing(problem, test) <= test.tolerance * static_depth;
}

double measured_critical_step(ParticleProblem problem, double low, double high, double relative_width,
                              const SettlingTest& test)
{
    const auto settles_at = [&](double dt) {
        problem.dt = dt;
        return settles(problem, test);
    };
    if (!settles_at(low) || settles_at(high))
        throw std::logic_error(
            "the particle has to settle at the lower end of the bracket and not at the upper");
    while (high - low > relative_width * low) {
        const double middle = 0.5 * (low + high);
        (settles_at(middle) ? low : high) = middle;
    }
    return low;
}
//! [settles]

}  // namespace enduring
