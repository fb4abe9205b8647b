#include "chapters/08_speculative_contacts/experiments/driven_scenes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace enduring::chapter08;

TEST_CASE("given motion: a cube rides on a piston as its table says")
{
    for (const double dt : {0.01, 0.004})
        CHECK(std::abs(piston(dt).error()) < 1e-3);
}

TEST_CASE("given motion: a block slides off a turntable at the speed that friction allows")
{
    CHECK(std::abs(turntable_slip(0.01).error()) < 0.01);
}

TEST_CASE("running surface: a block on a belt slides until it is as fast, and the drive pays for the heat")
{
    for (const double dt : {0.01, 0.003}) {
        const Conveyed conveyed = conveyor(dt);
        CHECK(std::abs(conveyed.slid.error()) < 3 * dt);
        CHECK(std::abs(conveyed.heat.error()) < 1e-9);
    }
}

TEST_CASE("outside load: a force pushes a puck by (F/m - mu g) t^2 / 2")
{
    for (const double dt : {0.01, 0.004})
        CHECK(std::abs(pushed_puck(dt).error()) < 1.5 * dt);  // symplectic Euler is half a step ahead
}

TEST_CASE(
    "held directions: a torque and a force on the rim turn a wheel by T t / I, and a slider keeps its momentum when hit")
{
    for (const double dt : {0.01, 0.004}) {
        CHECK(std::abs(torque_on_wheel(dt).error()) < 1e-9);
        CHECK(std::abs(hit_slider(dt).error()) < 1e-5);
    }
}

TEST_CASE("materials: a block holds and slides by the coefficients of its pair of materials")
{
    const double angle = std::atan(0.5) * 180 / std::numbers::pi;
    for (const double dt : {0.01, 0.004}) {
        CHECK(materials_hold(angle - 0.3, dt));
        CHECK_FALSE(materials_hold(angle + 0.3, dt));
        CHECK(std::abs(slide_of_materials(30, dt).error()) < 0.01);
    }
}
