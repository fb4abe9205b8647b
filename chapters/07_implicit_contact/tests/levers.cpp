#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace enduring;

namespace {

constexpr double radius = 0.1, mu = 0.5;

Quaternion random_turn(unsigned seed)
{
    std::mt19937 generator(seed);
    std::normal_distribution<double> draw;
    return Quaternion(draw(generator), draw(generator), draw(generator), draw(generator)).normalized();
}

/// A ball of a kilogram above the ground.
Scene falling_ball(double drop, double along, double restitution, double dt, int subdivisions,
                   const Quaternion& turn)
{
    Scene scene = chapter07::scene_of({}, dt, 0, mu, mu);
    scene.world.restitution.between = {restitution};
    SurfaceMesh mesh = sphere(radius, subdivisions);
    double lowest = 0;
    for (Vec3& vertex : mesh.vertices) {
        vertex = turn * vertex;
        lowest = std::min(lowest, vertex.y());
    }
    for (Vec3& vertex : mesh.vertices)
        vertex.y() += drop - lowest;
    scene.world.bodies.push_back(
        std::make_unique<RigidBody>("ball", mesh, with_mass(mass_properties(mesh, 1), 1), Vec3(along, 0, 0)));
    return scene;
}

const RigidMotion& ball_of(const Scene& scene)
{
    return dynamic_cast<const RigidBody&>(*scene.world.bodies[0]).motion();
}

/// The speed at which a ball that came down sliding begins to roll, over that by its moment of inertia.
double rolling_speed(double drop, double restitution, double dt, unsigned seed)
{
    constexpr double along = 2;
    Scene scene = falling_ball(drop, along, restitution, dt, 4, random_turn(seed));
    const RigidMotion& ball = ball_of(scene);
    const double inertia = 3 / ball.inverse_inertia().trace(),
                 right = along / (1 + inertia / (ball.mass() * radius * radius));
    const Solver solver = chapter07_solver(scene.contact);
    Contacts contacts;
    int behind = 0;  // steps since it rolls
    while (behind < 3 && scene.world.time < 5) {
        advance(scene.world, contacts, solver, dt);
        behind += std::abs(ball.velocity().x() + radius * ball.angular_velocity().z()) < 0.05 * along;
    }
    return ball.velocity().x() / right;
}

}  // namespace

TEST_CASE("levers: a ball that comes down sliding rolls with 5/7 of its speed, also in long steps")
{
    for (const double restitution : {0.0, 0.5})
        for (const double dt : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
            CAPTURE(restitution);
            CAPTURE(dt);
            constexpr int turns = 6;  // a facet's corner makes up to some percent in one of them
            double mean = 0;
            for (unsigned seed = 1; seed <= turns; ++seed)
                mean += rolling_speed(0.3, restitution, dt, seed) / turns;
            // its path in a step is R sin(w dt), not R w dt
            const double turn = dt * 5.0 / 7 * 2 / radius;
            CHECK(mean == doctest::Approx(1 - (1 - std::sin(turn) / turn) * 2 / 7).epsilon(0.01));
        }
}

TEST_CASE("levers: a ball that drops straight does not spin, whatever it bounces with, and no pair pulls")
{
    for (const double restitution : {0.0, 0.5, 1.0})
        for (int phase = 0; phase < 10; ++phase) {
            CAPTURE(restitution);
            CAPTURE(phase);
            constexpr double dt = 1.0 / 60;
            Scene scene = falling_ball(0.2 + 0.02 * phase, 0, restitution, dt, 3, Quaternion::Identity());
            const Solver solver = chapter07_solver(scene.contact);
            Contacts contacts;
            double pulled = 0, spin = 0;
            for (int i = 0; i < 40; ++i) {
                advance(scene.world, contacts, solver, dt);
                spin = std::max(spin, ball_of(scene).angular_velocity().norm());
                for (const Contact& contact : contacts)
                    pulled = std::min(pulled, contact.impulse.y());
            }
            CHECK(spin < 1e-8);
            CHECK(pulled >= 0);
        }
}
