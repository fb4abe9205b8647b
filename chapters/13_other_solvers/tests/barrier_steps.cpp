#include "chapters/13_other_solvers/tests/small_scenes.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

namespace {

/// A cube that spins and is thrown at the ground, without gravity.
Scene spinning_cube(double spin, const Vec3& axis, double turn_deg)
{
    Scene scene = chapter07::scene_of({{10, Vec3(0, 1, 0), turn_deg, Vec3(1, 2, 3).normalized(),
                                        Vec3(1, 0.6, 0.8), spin * axis.normalized()}},
                                      0.01);
    scene.world.gravity.setZero();
    scene.world.bodies[0]->kick({}, (Eigen::VectorXd(6) << 0, -50, 0, 0, 0, 0).finished(), scene.dt);
    return scene;
}

/// The most that the kinetic energy rises in a step [1].
double gain(Scene scene, const BarrierSettings& settings)
{
    const Solver solver = chapter13_barrier_solver(scene.contact, settings);
    double most = 0, before = scene.world.bodies[0]->energy(Vec3::Zero()).kinetic;
    Contacts contacts;
    for (int step = 0; step < 25; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        const double after = scene.world.bodies[0]->energy(Vec3::Zero()).kinetic;
        most = std::max(most, after / before - 1);
        before = after;
    }
    return most;
}

}  // namespace

TEST_CASE(
    "barrier: what turns by more than half a radian in a step gains no energy, for its steps are halved")
{
    struct Thrown {
        double spin;
        Vec3 axis;
        double turn_deg;
    };
    // found among thirty at random: whole steps of these gain most
    for (const auto& [spin, axis, turn] : {Thrown{135, Vec3(0.52584, -0.240393, 0.883674), -52.0883},
                                           Thrown{140, Vec3(-0.69414, 0.545478, -0.397279), 97.7742},
                                           Thrown{145, Vec3(-0.0587184, 0.418085, -0.981984), 28.3082}}) {
        CAPTURE(spin);
        CHECK(gain(spinning_cube(spin, axis, turn), {.max_halvings = 0}) >= 0.3);
        CHECK(gain(spinning_cube(spin, axis, turn), {}) <= 1e-3);
    }
}

TEST_CASE("barrier: a step that ends before its tolerance is told, and with halvings it is taken in parts")
{
    Scene scene = one_cube(0.01);
    run(scene, chapter13_barrier_solver(scene.contact, {.max_steps = 1, .max_halvings = 1}), 0.2);
    CHECK(scene.world.thrown_away > 0);
    CHECK(scene.world.ended_badly > 0);

    Scene sound = chapter07::scene_of(chapter07::stack_of(3), 0.01);
    run(sound, chapter13_barrier_solver(sound.contact), 0.3);
    CHECK(sound.world.ended_badly == 0);
}
