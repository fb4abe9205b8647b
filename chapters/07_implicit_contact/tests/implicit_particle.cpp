#include "chapters/07_implicit_contact/implicit_particle.hpp"

#include "chapters/01_particle_plane/plane_impulse.hpp"
#include "chapters/07_implicit_contact/experiments/measured_radius.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;
using chapter07::particle_with;

namespace {

const double stiffnesses[] = {0.01, 0.3, 1, 16, 100, 3000};
const PositionUpdate updates[] = {PositionUpdate::end_velocity, PositionUpdate::mean_velocity};

}  // namespace

TEST_CASE("implicit particle: the impulse of a step is that of the way that the step makes")
{
    for (const double h : stiffnesses)
        for (const PositionUpdate update : updates) {
            const ImplicitParticle problem = particle_with(h, 0.5, update);
            ParticleState state{0.02, -1};
            for (int i = 0; i < 50; ++i) {
                const ParticleState next = step(state, problem);
                const double impulse = problem.mass *
                                       (next.velocity - state.velocity + problem.gravity * problem.dt);
                const double charged = continuous_plane_impulse(state.height, next.height, problem.stiffness,
                                                                problem.dt);
                CAPTURE(h);
                CHECK(std::abs(impulse - charged) <= 1e-11 * (1 + h));
                state = next;
            }
        }
}

TEST_CASE("implicit particle: it rests at -m g / k, whatever the step and the weight")
{
    for (const double h : stiffnesses)
        for (const double centre : {0.5, 2.0 / 3, 1.0}) {
            const ImplicitParticle problem = particle_with(h, centre);
            const double rest = -problem.mass * problem.gravity / problem.stiffness;
            const ParticleState end = simulate({0.03, 0}, problem, 20000);
            CAPTURE(h);
            CAPTURE(centre);
            CHECK(end.height == doctest::Approx(rest).epsilon(1e-6));
            CHECK(std::abs(end.velocity) <= 1e-6 * std::abs(rest) / problem.dt);
        }
}

TEST_CASE(
    "implicit particle: moved by the mean velocity it keeps its energy through every bounce, to 1e-10 in 100,000 steps")
{
    for (const double h : {0.01, 0.1, 1.0, 10.0, 100.0}) {
        const ImplicitParticle problem = particle_with(h, 0.5, PositionUpdate::mean_velocity);
        ParticleState state{0.1, 0};
        const double first = energy(state, problem);
        double worst = 0;
        bool was_inside = false, came_out = false;
        for (int i = 0; i < 100000; ++i) {
            state = step(state, problem);
            worst = std::max(worst, std::abs(energy(state, problem) - first));
            was_inside = was_inside || state.height < 0;
            came_out = came_out || (was_inside && state.height > 0.05);
        }
        CAPTURE(h);
        CHECK(worst <= 1e-10 * first);
        CHECK(came_out);
    }
}

TEST_CASE("implicit particle: moved by the end's velocity a step costs m (v' - v)^2 / 2 and nothing else")
{
    for (const double h : stiffnesses) {
        const ImplicitParticle problem = particle_with(h, 0.5);
        ParticleState state{0.05, -2};
        for (int i = 0; i < 500; ++i) {
            const ParticleState next = step(state, problem);
            const double change = next.velocity - state.velocity;
            const double lost = energy(state, problem) - energy(next, problem);
            CAPTURE(h);
            CHECK(std::abs(lost - 0.5 * problem.mass * change * change) <= 1e-11 * (1 + h));
            state = next;
        }
    }
}

TEST_CASE("implicit particle: no weight that grows over the step gains energy, at any stiffness")
{
    for (const double h : {0.5, 5.0, 100.0, 1e5})
        for (const double centre : {0.5, 0.55, 2.0 / 3, 0.9, 1.0})
            for (const PositionUpdate update : updates) {
                const ImplicitParticle problem = particle_with(h, centre, update);
                ParticleState state{0.013, -3};
                for (int i = 0; i < 3000; ++i) {
                    const ParticleState next = step(state, problem);
                    CHECK(energy(next, problem) <= energy(state, problem) + 1e-10 * (1 + h));
                    state = next;
                }
            }
}

TEST_CASE("implicit particle: Newton's method answers within 12 steps up to h = 100")
{
    for (const double h : {0.01, 1.0, 16.0, 100.0}) {
        const ImplicitParticle problem = particle_with(h, 0.5);
        ParticleState state{0.1, 0};
        for (int i = 0; i < 2000; ++i) {
            int newton_steps = 0;
            const ParticleState next = step(state, problem, &newton_steps);
            CAPTURE(h);
            CHECK(newton_steps <= 12);
            state = next;
        }
    }
}

TEST_CASE("implicit particle: a step through the air takes no step of Newton's method")
{
    int newton_steps = -1;
    const ImplicitParticle problem = particle_with(16, 0.5, PositionUpdate::end_velocity);
    const ParticleState next = step({1, -0.1}, problem, &newton_steps);
    CHECK(next.height > 0);
    CHECK(newton_steps == 0);
}
