#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/01_particle_plane/settling.hpp"

#include <doctest/doctest.h>
#include <Eigen/Eigenvalues>

#include <cmath>

using namespace enduring;

namespace {

const PenaltyMethod both[] = {PenaltyMethod::discrete, PenaltyMethod::continuous};

}  // namespace

TEST_CASE(
    "amplification: the matrix is what a simulated step does to a departure from rest, gravity included")
{
    for (const PenaltyMethod method : both)
        for (const double dt : {0.01, 0.05, 0.11}) {
            CAPTURE(short_name(method));
            CAPTURE(dt);
            ParticleProblem problem;
            problem.mass = 0.7;
            problem.method = method;
            problem.dt = dt;
            const double rest = resting_height(problem);
            const Eigen::Matrix2d a = amplification(method, problem.mass, problem.stiffness, dt);
            for (const Eigen::Vector2d& off :
                 {Eigen::Vector2d(1e-4, 0), Eigen::Vector2d(0, 1e-3), Eigen::Vector2d(-2e-4, 5e-4)}) {
                const ParticleState after = step({rest + off.x(), off.y()}, problem);
                const Eigen::Vector2d expected = a * off;
                CHECK(std::abs(after.height - rest - expected.x()) <= 1e-14);
                CHECK(std::abs(after.velocity - expected.y()) <= 1e-13);
            }
        }
}

TEST_CASE("amplification: the spectral radius is that of a general eigenvalue solver")
{
    for (const PenaltyMethod method : both)
        for (double dt = 0.005; dt < 0.25; dt += 0.005) {
            const Eigen::Matrix2d a = amplification(method, 1, 100, dt);
            CHECK(spectral_radius(a) == doctest::Approx(a.eigenvalues().cwiseAbs().maxCoeff()).epsilon(1e-7));
        }
}

TEST_CASE("amplification: the radius is below 1 up to the critical step, 1 at it, above 1 beyond")
{
    for (const PenaltyMethod method : both)
        for (const double k : {10.0, 100.0, 5000.0}) {
            const double dt = critical_step(method, 0.3, k);
            CHECK(spectral_radius(amplification(method, 0.3, k, dt)) == doctest::Approx(1).epsilon(1e-12));
            for (int i = 1; i < 100; ++i)
                CHECK(spectral_radius(amplification(method, 0.3, k, dt * i / 100)) < 1);
            CHECK(spectral_radius(amplification(method, 0.3, k, 1.0001 * dt)) > 1);
        }
}

TEST_CASE("amplification: a swing decays as an oscillator with a damper k dt (DPF) or k dt / 2 (CPF)")
{
    // To leading order in h = k dt^2 / m: rho = 1 - zeta sqrt(h) with
    // zeta = c / (2 sqrt(k m)), theta = sqrt(h).
    const double k = 1000, mass = 2, dt = 1e-4, h = k * dt * dt / mass;
    for (const PenaltyMethod method : both) {
        const double damper = (method == PenaltyMethod::discrete ? 1.0 : 0.5) * k * dt;
        const double zeta = damper / (2 * std::sqrt(k * mass));
        const Decay swing = decay(amplification(method, mass, k, dt));
        CHECK((1 - swing.per_step) / std::sqrt(h) == doctest::Approx(zeta).epsilon(1e-4));
        CHECK(swing.steps_per_contact * std::sqrt(h) == doctest::Approx(3.141592653589793).epsilon(1e-4));
        CHECK(swing.per_contact == doctest::Approx(std::exp(-3.141592653589793 * zeta)).epsilon(1e-4));
    }
    CHECK_THROWS_AS(decay(amplification(PenaltyMethod::discrete, 1, 100, 0.11)), std::domain_error);
}

TEST_CASE("critical step: simulation and eigenvalues agree within 1%, and so does their ratio with sqrt(3/2)")
{
    double measured[2] = {};
    for (const PenaltyMethod method : both) {
        CAPTURE(short_name(method));
        ParticleProblem problem;
        problem.method = method;
        const double analytic = critical_step(method, problem.mass, problem.stiffness);
        SettlingTest test;
        test.steps = 5000;
        const double found = measured_critical_step(problem, 0.5 * analytic, 1.5 * analytic, 1e-4, test);
        CHECK(found == doctest::Approx(analytic).epsilon(0.01));
        measured[method == PenaltyMethod::discrete ? 0 : 1] = found;
    }
    CHECK(measured[1] / measured[0] == doctest::Approx(1.2247).epsilon(0.01));
}

TEST_CASE("critical step: it is the same whatever the drop height, the mass and the stiffness")
{
    for (const PenaltyMethod method : both)
        for (const double drop_height : {1e-3, 0.1, 3.0})
            for (const double k : {50.0, 20000.0}) {
                ParticleProblem problem{0.4, k, 9.81, method, 0};
                const double analytic = critical_step(method, problem.mass, k);
                SettlingTest test;
                test.drop_height = drop_height;
                CAPTURE(short_name(method));
                CAPTURE(drop_height);
                problem.dt = 0.99 * analytic;
                CHECK(settles(problem, test));
                problem.dt = 1.01 * analytic;
                CHECK_FALSE(settles(problem, test));
            }
}

TEST_CASE("critical step: an unstable contact stays bounded, so a test for blow-up would not find it")
{
    for (const PenaltyMethod method : both) {
        ParticleProblem problem;
        problem.method = method;
        problem.dt = 1.1 * critical_step(method, problem.mass, problem.stiffness);
        CHECK_FALSE(settles(problem));
        for (const double height : last_heights(problem))
            CHECK(std::abs(height) < 1.0);
    }
}

TEST_CASE("critical step: a bracket without the change is refused")
{
    CHECK_THROWS_AS(measured_critical_step(ParticleProblem{}, 0.01, 0.05), std::logic_error);
}
