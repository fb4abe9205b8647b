#include "chapters/01_particle_plane/plane_impulse.hpp"
#include "chapters/07_implicit_contact/implicit_particle.hpp"
#include "exercises/checking.hpp"

#include <cmath>

namespace enduring {
namespace {

ImplicitParticle ground(double stiffness, PositionUpdate update = PositionUpdate::end_velocity)
{
    ImplicitParticle problem;
    problem.stiffness = stiffness;
    problem.update = update;
    return problem;
}

}  // namespace

TEST_CASE("step: above the ground it falls as symplectic Euler says")
{
    given("height 1 m, velocity 2 m/s, dt 0.01 s, end velocity");
    const ParticleState next = step({1, 2}, ground(100));
    expect("velocity", next.velocity, 2 - 0.0981, 1e-12, "m/s");
    expect("height", next.height, 1 + 0.01 * (2 - 0.0981), 1e-12, "m");
}

TEST_CASE("step: inside throughout, the answer is that of the linear equation")
{
    given("height -0.1 m, velocity -30 m/s, k 10 000 N/m, m 1 kg, dt 0.01 s, end velocity, CPF");
    expect("velocity", step({-0.1, -30}, ground(10000)).velocity, (-30 - 0.0981 + 0.1 / 0.01) / 1.5, 1e-9,
           "m/s");
}

TEST_CASE("step: the impulse is that of the way which the step takes")
{
    for (const double stiffness : {1e3, 1e5, 1e7})
        for (const PositionUpdate update : {PositionUpdate::end_velocity, PositionUpdate::mean_velocity}) {
            given("height 0.005 m, velocity -1 m/s, k ", stiffness, " N/m, m 1 kg, ",
                  update == PositionUpdate::end_velocity ? "end" : "mean", " velocity");
            const ImplicitParticle problem = ground(stiffness, update);
            const ParticleState next = step({0.005, -1}, problem);
            const double impulse = next.velocity + 1 + 9.81 * problem.dt;
            expect("impulse", impulse, continuous_plane_impulse(0.005, next.height, stiffness, problem.dt),
                   1e-8, "N s");
        }
}

TEST_CASE("step: by the mean velocity the height moves by the mean of both velocities")
{
    given("height 0.005 m, velocity -1 m/s, k 100 000 N/m, m 1 kg, mean velocity");
    const ParticleState next = step({0.005, -1}, ground(1e5, PositionUpdate::mean_velocity));
    expect("height", next.height, 0.005 + 0.01 * 0.5 * (next.velocity - 1), 1e-12, "m");
}

TEST_CASE("step: mass, gravity, the centre of the weight and the length of the step count")
{
    const double mass = 3, k = 5000, gravity = 2, centre = 0.8, dt = 0.02, height = -0.1, velocity = -1;
    given("height -0.1 m, velocity -1 m/s, m 3 kg, k 5000 N/m, g 2 m/s^2, centre 0.8, dt 0.02 s");
    const ParticleState by_end = step({height, velocity},
                                      {mass, k, gravity, centre, PositionUpdate::end_velocity, dt});
    const double free_velocity = velocity - gravity * dt, stiff = centre * k * dt * dt;
    expect("velocity, moved by the end's", by_end.velocity,
           (mass * free_velocity - k * dt * height) / (mass + stiff), 1e-12, "m/s");
    const ParticleState by_mean = step({height, velocity},
                                       {mass, k, gravity, centre, PositionUpdate::mean_velocity, dt});
    const double mean = (mass * (velocity + free_velocity) - k * dt * height) / (2 * mass + stiff);
    expect("velocity, moved by the mean", by_mean.velocity, 2 * mean - velocity, 1e-12, "m/s");
    expect("height, moved by the mean", by_mean.height, height + dt * mean, 1e-12, "m");
}

TEST_CASE("step: it tells how many steps of Newton's method it took, and they are few")
{
    int count = -1;
    step({1, 0}, ground(1e6), &count);
    given("height 1 m, velocity 0: the ground does not push");
    expect_that("0 or 1 steps are told; got: " + readable(count), count == 0 || count == 1);
    for (const double height : {-0.001, 0.005}) {
        count = -1;
        step({height, -1}, ground(1e6), &count);
        given("height ", height, " m, velocity -1 m/s, k 1 000 000 N/m, m 1 kg, dt 0.01 s");
        expect_that("1 to 13 steps are told; got: " + readable(count), count >= 1 && count <= 13);
    }
}

TEST_CASE("energy: kinetic, of the height, and of the ground's spring while it is compressed")
{
    const ImplicitParticle problem = ground(1000);
    given("height 0.5 m, velocity 2 m/s");
    expect("energy", energy({0.5, 2}, problem), 2 + 9.81 * 0.5, 1e-12, "J");
    given("height -0.1 m, velocity 0, k 1000 N/m");
    expect("energy", energy({-0.1, 0}, problem), -0.981 + 5, 1e-12, "J");
    ImplicitParticle heavy = ground(1000);
    heavy.mass = 3;
    heavy.gravity = 2;
    given("height -0.1 m, velocity 2 m/s, m 3 kg, g 2 m/s^2, k 1000 N/m");
    expect("energy", energy({-0.1, 2}, heavy), 6 - 0.6 + 5, 1e-12, "J");
}

TEST_CASE("bounce: by the mean velocity it costs nothing, on a soft and on a stiff ground")
{
    for (const double stiffness : {1e3, 1e6}) {
        given("dropped from 0.1 m, k ", stiffness, " N/m, m 1 kg, 10 000 steps, mean velocity");
        const ImplicitParticle problem = ground(stiffness, PositionUpdate::mean_velocity);
        const ParticleState end = simulate({0.1, 0}, problem, 10000);
        const double left = energy(end, problem) / energy({0.1, 0}, problem);
        expect("energy over the first", left, 1.0, 1e-9);
        say("k ", stiffness, " N/m: after 10 000 steps the particle has its energy");
    }
}

TEST_CASE("rest: it rests at - m g / k")
{
    given("dropped from 0.01 m, k 160 000 N/m, m 1 kg, end velocity");
    const ParticleState end = simulate({0.01, 0}, ground(160000), 2000);
    expect("height", end.height, -9.81 / 160000, 1e-9, "m");
    say("at rest ", 1000 * end.height, " mm");
}

}  // namespace enduring
