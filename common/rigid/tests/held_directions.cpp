#include "common/geometry/box_shapes.hpp"
#include "common/input/input_error.hpp"
#include "common/rigid/rigid_motion.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

/// A brick whose axes lie askew, away from the origin.
MassProperties askew_brick()
{
    SurfaceMesh mesh = box({2, 1, 0.5});
    const Quaternion turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()));
    for (Vec3& vertex : mesh.vertices)
        vertex = turn * vertex + Vec3(3, 4, 5);
    return with_mass(mass_properties(mesh, 1), 8);
}

FreeDirections held(const Vec3& translation, const Vec3& rotation)
{
    return {Vec3::Ones() - translation, Vec3::Ones() - rotation};
}

}  // namespace

TEST_CASE("held directions: a body that turns about one axis has T / I about it, however it lies")
{
    const MassProperties properties = askew_brick();
    RigidMotion motion(properties);
    motion.hold(held(Vec3::Ones(), Vec3(1, 0, 1)));
    const double inertia = properties.inertia(1, 1);
    constexpr double dt = 0.01;
    for (int step = 1; step <= 200; ++step) {
        motion.predict(Vec3(0, -9.81, 0), dt);
        motion.apply_momentum(dt * Vec3(7, 8, 9), dt * Vec3(1, 2, 3));
        motion.commit(dt);
        CHECK((motion.angular_velocity() - Vec3(0, 2 * dt * step / inertia, 0)).norm() < 1e-11);
    }
    CHECK(motion.centre() == properties.centre);
    CHECK(motion.velocity().isZero(0));
    const double spin = motion.angular_velocity().y();
    CHECK(motion.kinetic_energy() == doctest::Approx(0.5 * inertia * spin * spin));
    CHECK(motion.angular_momentum(motion.centre()).y() == doctest::Approx(inertia * spin));
}

TEST_CASE(
    "held directions: translations along free axes are those of a free body, along held ones there are none")
{
    RigidMotion motion(askew_brick(), Vec3(1, 0, 0)), free(askew_brick(), Vec3(1, 0, 0));
    motion.hold(held(Vec3(0, 1, 0), Vec3::Ones()));
    for (int step = 0; step < 10; ++step)
        for (RigidMotion* one : {&motion, &free}) {
            one->predict(Vec3(0.5, -9.81, 2), 0.02);
            one->apply_momentum(Vec3(0.3, 4, 0.1), Vec3(1, 1, 1));
            one->commit(0.02);
        }
    CHECK(motion.velocity() == Vec3(free.velocity().x(), 0, free.velocity().z()));
    CHECK(motion.angular_velocity().isZero(0));
    CHECK(motion.centre().y() == askew_brick().centre.y());
}

namespace {

struct Tumble {
    double energy_error = 0;   ///< the largest, over the first energy
    double free_error = 0;     ///< of the angular momentum about free axes, the largest [N m s]
    double held_change = 0;    ///< of that about the held axis, the largest [N m s]
    double held_velocity = 0;  ///< about the held axis, the largest [rad/s]
};

/// The brick tumbles for eight seconds with its turns about y held.
Tumble tumble(double dt)
{
    RigidMotion motion(askew_brick(), Vec3::Zero(), Vec3(3, 0, -2));
    motion.hold(held(Vec3::Zero(), Vec3(0, 1, 0)));
    const double energy = motion.kinetic_energy();
    const Vec3 momentum = motion.angular_momentum(motion.centre());
    Tumble worst;
    for (int step = 0; step * dt < 8; ++step) {
        motion.predict(Vec3::Zero(), dt);
        worst.held_velocity = std::max(worst.held_velocity, std::abs(motion.angular_velocity().y()));
        motion.commit(dt);
        const Vec3 change = motion.angular_momentum(motion.centre()) - momentum;
        worst.energy_error = std::max(worst.energy_error, std::abs(motion.kinetic_energy() / energy - 1));
        worst.free_error = std::max({worst.free_error, std::abs(change.x()), std::abs(change.z())});
        worst.held_change = std::max(worst.held_change, std::abs(change.y()));
    }
    return worst;
}

}  // namespace

TEST_CASE(
    "held directions: with one turn held the momentum about free axes stays while it tumbles, and energy to second order")
{
    const MassProperties properties = askew_brick();
    RigidMotion motion(properties, Vec3::Zero(), Vec3(3, 0, -2));
    motion.hold(held(Vec3::Zero(), Vec3(0, 1, 0)));
    CHECK(motion.kinetic_energy() ==
          doctest::Approx(0.5 * Vec3(3, 0, -2).dot(properties.inertia * Vec3(3, 0, -2))));
    const Tumble coarse = tumble(0.02), fine = tumble(0.01);
    CHECK(coarse.energy_error < 1e-3);
    CHECK(coarse.energy_error > 3 * fine.energy_error);
    CHECK(coarse.free_error < 1e-12);
    CHECK(coarse.held_change > 0.1);  // by the lock's torque
    CHECK(coarse.held_velocity == 0);
}

TEST_CASE("held directions: an impulse changes a velocity by what the inverse mass at its point says")
{
    RigidMotion motion(askew_brick());
    motion.hold(held(Vec3(1, 0, 0), Vec3(0, 0, 1)));
    const Vec3 point(3.4, 4.3, 4.8), impulse(1, -2, 3);
    const Vec3 expected = motion.inverse_mass_at(point) * impulse;
    motion.apply_impulse(impulse, point);
    CHECK((motion.velocity_at(point) - expected).norm() < 1e-14);
    CHECK(motion.velocity().x() == 0);
    CHECK(motion.angular_velocity().z() == 0);
}

TEST_CASE("held directions: a body that moves along what is held is refused")
{
    RigidMotion motion(askew_brick(), Vec3(1, 0, 0), Vec3(0, 2, 0));
    CHECK_THROWS_AS(motion.hold(held(Vec3(1, 0, 0), Vec3::Zero())), InputError);
    CHECK_THROWS_AS(motion.hold(held(Vec3::Zero(), Vec3(0, 1, 0))), InputError);
    CHECK_NOTHROW(motion.hold(held(Vec3(0, 1, 1), Vec3(1, 0, 1))));
}
