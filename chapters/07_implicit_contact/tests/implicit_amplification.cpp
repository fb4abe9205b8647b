#include "chapters/07_implicit_contact/experiments/implicit_amplification.hpp"

#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/07_implicit_contact/experiments/measured_radius.hpp"

#include <doctest/doctest.h>
#include <Eigen/Eigenvalues>

#include <cmath>

using namespace enduring;
using chapter07::particle_with;

namespace {

double radius_of(double h, double centre)
{
    return amplification(particle_with(h, centre)).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("implicit amplification: the matrix is what a simulated step does to a departure from rest")
{
    for (const double h : {0.1, 4.0, 16.0, 500.0})
        for (const double centre : {0.3, 0.5, 0.8, 1.0})
            for (const PositionUpdate update :
                 {PositionUpdate::end_velocity, PositionUpdate::mean_velocity}) {
                const ImplicitParticle problem = particle_with(h, centre, update);
                const Eigen::Matrix2d a = amplification(problem);
                const double rest = -problem.mass * problem.gravity / problem.stiffness;
                for (const Eigen::Vector2d& off : {Eigen::Vector2d(0.1 * rest, 0),
                                                   Eigen::Vector2d(-0.05 * rest, 0.1 * rest / problem.dt)}) {
                    const ParticleState after = step({rest + off.x(), off.y()}, problem);
                    const Eigen::Vector2d expected = a * off;
                    CHECK(after.height - rest == doctest::Approx(expected.x()).epsilon(1e-7));
                    CHECK(after.velocity == doctest::Approx(expected.y()).epsilon(1e-7));
                }
            }
}

TEST_CASE(
    "implicit amplification: with its centre in the middle or later a step is stable for every h, before it up to 4 / (1 - 2 centre)")
{
    for (const double centre : {0.5, 0.51, 2.0 / 3, 1.0})
        for (double h = 1e-3; h < 1e6; h *= 1.7)
            CHECK(radius_of(h, centre) < 1);
    for (const double centre : {0.05, 0.2, 0.45}) {
        CHECK(radius_of(0.999 * stable_below(centre), centre) < 1);
        CHECK(radius_of(1.001 * stable_below(centre), centre) > 1);
    }
}

TEST_CASE("implicit amplification: both eigenvalues of CPF are -1/3 at h = 16, and no other h is faster")
{
    const Eigen::Vector2cd both = amplification(particle_with(16, 0.5)).eigenvalues();
    for (const auto& eigenvalue : both)
        CHECK(std::abs(eigenvalue + 1.0 / 3) <= 1e-7);
    for (double h = 0.01; h < 1e5; h *= 1.1)
        CHECK(radius_of(h, 0.5) >= 1.0 / 3 - 1e-7);
    CHECK(fastest_stiffness(0.5) == doctest::Approx(16));
    CHECK(fastest_factor(0.5) == doctest::Approx(-1.0 / 3));
}

TEST_CASE("implicit amplification: the fastest h and the ring far beyond it, for other weights")
{
    for (const double centre : {0.5, 0.6, 2.0 / 3, 0.9}) {
        CAPTURE(centre);
        const double h = fastest_stiffness(centre);
        CHECK(radius_of(h, centre) == doctest::Approx(std::abs(fastest_factor(centre))).epsilon(1e-6));
        CHECK(radius_of(0.7 * h, centre) > std::abs(fastest_factor(centre)));
        CHECK(radius_of(1.4 * h, centre) > std::abs(fastest_factor(centre)));
        CHECK(radius_of(1e9, centre) == doctest::Approx(std::abs(ringing_factor(centre))).epsilon(1e-6));
    }
}

TEST_CASE("implicit amplification: four heights of a simulation tell the spectral radius of its matrix")
{
    for (const double h : {0.01, 1.0, 16.0, 200.0, 1e4})
        for (const double centre : {0.25, 0.5, 2.0 / 3, 1.0})
            CHECK(chapter07::measured_radius(particle_with(h, centre)) ==
                  doctest::Approx(spectral_radius(amplification(particle_with(h, centre)))).epsilon(1e-5));
}

TEST_CASE(
    "implicit amplification: a dropped particle settles just where the eigenvalues say so, at any height of the drop")
{
    for (const double drop_height : {1e-3, 0.1, 2.0}) {
        for (const double h : {0.1, 16.0, 300.0})
            for (const double centre : {0.5, 2.0 / 3, 1.0})
                CHECK(chapter07::settles(particle_with(h, centre), drop_height));
        CHECK(chapter07::settles(particle_with(0.98 * stable_below(0.3), 0.3), drop_height));
        CHECK_FALSE(chapter07::settles(particle_with(1.02 * stable_below(0.3), 0.3), drop_height));
    }
}
