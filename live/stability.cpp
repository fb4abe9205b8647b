#include "chapters/01_particle_plane/amplification.hpp"
#include "live/figures.hpp"

#include <Eigen/Eigenvalues>

namespace enduring::live {

Numbers stability(bool continuous, double dt, double stiffness, int steps)
{
    ParticleProblem problem;
    problem.method = continuous ? PenaltyMethod::continuous : PenaltyMethod::discrete;
    problem.dt = dt;
    problem.stiffness = stiffness;
    const Eigen::Matrix2d a = amplification(problem.method, problem.mass, stiffness, dt);
    const Eigen::EigenSolver<Eigen::Matrix2d> solver(a, false);
    Numbers result{spectral_radius(a), critical_step(problem.method, problem.mass, stiffness)};
    for (int i = 0; i < 2; ++i)
        result.insert(result.end(), {solver.eigenvalues()[i].real(), solver.eigenvalues()[i].imag()});
    ParticleState state{0.1, 0};
    for (int i = 0; i < steps; ++i) {
        result.push_back(state.height);
        state = step(state, problem);
    }
    return result;
}

}  // namespace enduring::live
