#include "chapters/13_other_solvers/tests/small_scenes.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

TEST_CASE("XPBD: a cube on contacts of a compliance sinks by its load times the compliance")
{
    for (const double compliance : {1e-5, 1e-4}) {
        Scene scene = one_cube();
        run(scene, chapter13_xpbd_solver(scene.contact, {.iterations = 50, .compliance = compliance}), 4);
        // four springs, at which the cube arrives without a swing: velocities along the normal are taken away
        CHECK(0.5 - scene.world.bodies[0]->centre().y() ==
              doctest::Approx(10 * 9.81 / 4 * compliance).scale(0).epsilon(0.005));
    }
}

TEST_CASE("XPBD: twice the substeps leave a quarter of the depth")
{
    const auto depth = [](int substeps) {
        Scene scene = chapter07::scene_of(chapter07::stack_of(3), 0.01, 0, 0, 0);
        run(scene, chapter13_xpbd_solver(scene.contact, {.substeps = substeps}), 1);
        return 2.5 - scene.world.bodies[2]->centre().y();
    };
    CHECK(depth(10) / depth(20) == doctest::Approx(4).scale(0).epsilon(0.05));
}

TEST_CASE(
    "AVBD: the multiplier becomes the force within its bounds, and the stiffness grows where it is inside")
{
    const AvbdSettings settings{.beta = 100};
    const AugmentedConstraint inside = dual_update({2, 50}, 0.1, 0, 1e9, settings);
    CHECK(inside.multiplier == doctest::Approx(7));  // 2 + 50 0.1
    CHECK(inside.stiffness == doctest::Approx(60));  // 50 + 100 0.1
    const AugmentedConstraint open = dual_update({2, 50}, -0.1, 0, 1e9, settings);
    CHECK(open.multiplier == 0);
    CHECK(open.stiffness == 50);
    const AugmentedConstraint full = dual_update({2, 50}, 0.1, -5, 5, settings);
    CHECK(full.multiplier == 5);
    CHECK(full.stiffness == 50);
    CHECK(dual_update({0, 50}, 1e12, 0, 1e300, settings).stiffness == settings.most_stiffness);
}

TEST_CASE(
    "AVBD: a body alone is where its inertia brings it, and contact takes the part 1 - alpha of a depth in a step")
{
    Scene falls = one_cube(5);
    run(falls, chapter13_avbd_solver(falls.contact), 0.5);
    const double dt = falls.dt;
    CHECK(falls.world.bodies[0]->centre().y() ==
          doctest::Approx(5.5 - 9.81 * dt * dt * 50 * 51 / 2).scale(0).epsilon(1e-9));

    Scene deep = one_cube(-0.1);
    deep.world.gravity.setZero();
    const AvbdSettings settings{.iterations = 200, .alpha = 0.9, .beta = 1e7};
    const Solver solver = chapter13_avbd_solver(deep.contact, settings);
    Contacts contacts;
    advance(deep.world, contacts, solver, dt);
    CHECK(0.5 - deep.world.bodies[0]->centre().y() == doctest::Approx(0.09).scale(0).epsilon(1e-3));
}

TEST_CASE("AVBD: a stack sinks less with more sweeps")
{
    const auto sunk = [](int iterations) {
        Scene scene = chapter07::scene_of(chapter07::stack_of(5), 0.01);
        run(scene, chapter13_avbd_solver(scene.contact, {.iterations = iterations}), 1);
        return 4.5 - scene.world.bodies[4]->centre().y();
    };
    CHECK(sunk(40) < 0.5 * sunk(5));
    CHECK(sunk(40) > 0);
}
