#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/natural_map.hpp"
#include "live/figures.hpp"

namespace enduring::live {
namespace {

/// A block of 1 kg on the ground.
FrictionProblem block_of(const Vec3& free_velocity, double mu)
{
    Eigen::SparseMatrix<double> unit(3, 3);
    unit.setIdentity();
    FrictionProblem problem;
    problem.bodies = BodyEquations{unit, unit, Eigen::VectorXd::Zero(3), free_velocity};
    problem.mu = Eigen::VectorXd::Constant(1, mu);
    complete(problem, "the block");
    return problem;
}

void append_plane(Numbers& numbers, const Vec3& of) { numbers.insert(numbers.end(), {of.x(), of.y()}); }

}  // namespace

Numbers passes(double h, int count, double mu, double normal, double along)
{
    const FrictionProblem problem = block_of(Vec3(normal, along, 0), mu);
    Numbers result;
    append_plane(result, solve_exactly(problem).impulses);
    ExactSettings settings{.h = h, .keeps_h = true, .tolerance = 0};
    settings.max_idle_passes = count + 1;
    for (settings.max_passes = 1; settings.max_passes <= count; ++settings.max_passes) {
        const Vec3 impulse = solve_exactly(problem, settings).impulses,
                   velocity = contact_velocities(problem, impulse);
        append_plane(result, impulse);
        append_plane(result, velocity);
        append_plane(result, natural_map(impulse, velocity, mu));
        result.push_back(natural_map_error(problem, impulse));
    }
    return result;
}

}  // namespace enduring::live
