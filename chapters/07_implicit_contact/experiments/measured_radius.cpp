#include "chapters/07_implicit_contact/experiments/measured_radius.hpp"

#include "chapters/01_particle_plane/amplification.hpp"

#include <algorithm>

namespace enduring::chapter07 {

ImplicitParticle particle_with(double h, double centre, PositionUpdate update)
{
    ImplicitParticle problem;
    problem.stiffness = h * problem.mass / (problem.dt * problem.dt);
    problem.centre = centre;
    problem.update = update;
    return problem;
}

//! [measured_radius]
double measured_radius(const ImplicitParticle& problem)
{
    const double rest = -problem.mass * problem.gravity / problem.stiffness;
    ParticleState state{0.99 * rest, 0};  // so near that it never leaves the ground
    double y[4];
    for (double& offset : y) {
        offset = state.height - rest;
        state = step(state, problem);
    }
    // Two eigenvalues make every height from the two before: y2 = trace
    // y1 - determinant y0, and the same for y3.
    const double determinant = (y[2] * y[2] - y[1] * y[3]) / (y[1] * y[1] - y[0] * y[2]);
    Eigen::Matrix2d companion;
    companion << (y[2] + determinant * y[0]) / y[1], -determinant, 1, 0;
    return spectral_radius(companion);
}
//! [measured_radius]

bool settles(const ImplicitParticle& problem, double drop_height, int steps)
{
    const int watched = 200;
    ParticleState state = simulate({drop_height, 0}, problem, steps - watched);
    double lowest = state.height, highest = state.height;
    for (int i = 0; i < watched; ++i) {
        state = step(state, problem);
        lowest = std::min(lowest, state.height);
        highest = std::max(highest, state.height);
    }
    return highest - lowest <= 1e-6 * problem.mass * problem.gravity / problem.stiffness;
}

}  // namespace enduring::chapter07
