#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/07_implicit_contact/experiments/implicit_amplification.hpp"
#include "live/figures.hpp"

#include <Eigen/Eigenvalues>

namespace enduring::live {

Numbers implicit(double h, double centre, bool by_mean, int steps)
{
    ImplicitParticle problem;
    problem.stiffness = h * problem.mass / (problem.dt * problem.dt);
    problem.centre = centre;
    problem.update = by_mean ? PositionUpdate::mean_velocity : PositionUpdate::end_velocity;
    const Eigen::Matrix2d a = amplification(problem);
    const Eigen::EigenSolver<Eigen::Matrix2d> solver(a, false);
    Numbers result{spectral_radius(a), stable_below(centre)};
    for (int i = 0; i < 2; ++i)
        result.insert(result.end(), {solver.eigenvalues()[i].real(), solver.eigenvalues()[i].imag()});
    ParticleState state{0.1, 0};
    const double weight = problem.mass * problem.gravity,
                 at_rest = -weight * weight / (2 * problem.stiffness);
    const double first = energy(state, problem) - at_rest;
    for (int i = 0; i < steps; ++i) {
        result.insert(result.end(), {state.height, (energy(state, problem) - at_rest) / first});
        state = step(state, problem);
    }
    return result;
}

}  // namespace enduring::live
