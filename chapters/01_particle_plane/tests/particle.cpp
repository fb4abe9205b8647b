#include "chapters/01_particle_plane/particle.hpp"
#include "chapters/01_particle_plane/amplification.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

TEST_CASE("particle: without contact it falls as symplectic Euler says")
{
    ParticleProblem problem;
    const int n = 10;
    const ParticleState state = simulate({1, 2}, problem, n);
    CHECK(state.velocity == doctest::Approx(2 - n * 9.81 * 0.01));
    CHECK(state.height == doctest::Approx(1 + n * 0.01 * 2 - 9.81 * 1e-4 * n * (n + 1) / 2));
}

TEST_CASE("particle: the predicted rest is where the simulation ends, for both methods and all stable steps")
{
    for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous})
        for (const double part : {0.05, 0.3, 0.6, 0.9, 0.98}) {
            ParticleProblem problem{0.5, 400, 9.81, method, 0};
            problem.dt = part * critical_step(method, problem.mass, problem.stiffness);
            CAPTURE(short_name(method));
            CAPTURE(part);
            const ParticleState end = simulate({0.1, 0}, problem, 20000);
            CHECK(std::abs(end.height - resting_height(problem)) <= 1e-9);
            CHECK(std::abs(end.velocity) <= 1e-9);
            // not -mg/k
            CHECK(std::abs(end.height + problem.mass * problem.gravity / problem.stiffness) > 1e-5);
        }
}

TEST_CASE("particle: at rest the impulse balances the weight, below and above the plane")
{
    // Above 2m/k CPF's rest lies above the plane: unstable, but a rest all the same.
    for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous})
        for (const double dt : {0.01, 0.1, 0.14, 0.17, 0.3}) {
            ParticleProblem problem{1, 100, 9.81, method, dt};
            const double rest = resting_height(problem);
            const ParticleState after = step({rest, 0}, problem);
            CAPTURE(short_name(method));
            CAPTURE(dt);
            CHECK(std::abs(after.velocity) <= 1e-13);
            CHECK(std::abs(after.height - rest) <= 1e-14);
        }
}

TEST_CASE("particle: DPF can rest above the plane, CPF reaches it at its critical step")
{
    const double m = 1, k = 100;
    const double between = std::sqrt(1.2 * m / k);  // h = 1.2: stable for DPF
    CHECK(resting_height({m, k, 9.81, PenaltyMethod::discrete, between}) > 0.01);
    CHECK(std::abs(resting_height({m, k, 9.81, PenaltyMethod::continuous,
                                   critical_step(PenaltyMethod::continuous, m, k)})) <= 1e-15);
}

TEST_CASE("particle: the top of a flight is the same from every state on it")
{
    ParticleProblem problem;
    ParticleState state{0.05, 2};
    const double top = top_of_flight(state, problem);
    for (int i = 0; i < 30; ++i) {
        state = step(state, problem);
        CHECK(top_of_flight(state, problem) == doctest::Approx(top).epsilon(1e-12));
        CHECK(state.height <= top);
    }
}

TEST_CASE("particle: CPF keeps more of a bounce than DPF, and both keep more with a smaller step")
{
    const auto kept = [](PenaltyMethod method, double dt) {
        ParticleProblem problem{1, 1000, 9.81, method, dt};
        ParticleState state{0.1, 0};
        const int a_second = static_cast<int>(1 / dt);
        bool was_inside = false;
        for (int i = 0; i < a_second && !(was_inside && state.height > 0); ++i) {
            state = step(state, problem);
            was_inside = was_inside || state.height < 0;
        }
        CHECK(state.velocity > 0);
        return top_of_flight(state, problem) / 0.1;
    };
    for (const double dt : {0.01, 0.001, 0.0001}) {
        CAPTURE(dt);
        CHECK(kept(PenaltyMethod::continuous, dt) > kept(PenaltyMethod::discrete, dt));
        CHECK(kept(PenaltyMethod::continuous, dt) < 1.001);
        CHECK(kept(PenaltyMethod::discrete, dt / 10) > kept(PenaltyMethod::discrete, dt));
        CHECK(kept(PenaltyMethod::continuous, dt / 10) > kept(PenaltyMethod::continuous, dt));
    }
}
