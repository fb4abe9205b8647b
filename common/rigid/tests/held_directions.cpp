#include "common/geometry/box_shapes.hpp"
#include "common/input/input_error.hpp"
#include "common/rigid/rigid_motion.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
    "held directions: with axes of its own a body moves as one that is turned with them moves along the world's")
{
    const Quaternion turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, -2).normalized()));
    const MassProperties straight = askew_brick();
    MassProperties askew = straight;
    askew.centre = turn * straight.centre;
    askew.inertia = turn.toRotationMatrix() * straight.inertia * turn.toRotationMatrix().transpose();
    for (const Vec3& turns : {Vec3(1, 0, 1), Vec3(0, 1, 0), Vec3(1, 1, 1)})
        for (const bool is_pinned : {false, true}) {
            const FreeDirections free = held(Vec3(1, 0, 0), turns);
            RigidMotion one(straight, is_pinned ? Vec3(0, 0, 0) : Vec3(0, 3, 1)),
                other(askew, is_pinned ? Vec3(0, 0, 0) : Vec3(turn * Vec3(0, 3, 1)));
            if (is_pinned) {
                one.pin(Vec3(2, 4, 5), free.rotation);
                other.pin(turn * Vec3(2, 4, 5), free.rotation, turn.toRotationMatrix());
            } else {
                one.hold(free);
                other.hold({free.translation, free.rotation, turn.toRotationMatrix()});
            }
            for (int step = 0; step < 30; ++step) {
                one.predict(Vec3(1, -9.81, 3), 0.02);
                other.predict(turn * Vec3(1, -9.81, 3), 0.02);
                one.apply_impulse(Vec3(0.3, 4, 0.1), one.pose().position + Vec3(0.1, 0.2, 0.3));
                other.apply_impulse(turn * Vec3(0.3, 4, 0.1),
                                    other.pose().position + turn * Vec3(0.1, 0.2, 0.3));
                one.commit(0.02);
                other.commit(0.02);
                CAPTURE(step);
                CHECK((other.velocity() - turn * one.velocity()).norm() < 1e-11);
                CHECK((other.angular_velocity() - turn * one.angular_velocity()).norm() < 1e-11);
                CHECK((other.inverse_mass_at(other.pose().position + turn * Vec3(1, 2, 3)) -
                       turn.toRotationMatrix() * one.inverse_mass_at(one.pose().position + Vec3(1, 2, 3)) *
                           turn.toRotationMatrix().transpose())
                          .norm() < 1e-11);
            }
            CHECK((other.centre() - turn * one.centre()).norm() < 1e-10);
        }
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

namespace {

constexpr double earth = 9.81;  // [m/s^2]

/// A bar of 1 x 0.1 x 0.2 m and 3 kg that hangs on its end, on the z axis, and is turned away from the
/// vertical.
RigidMotion hanging_bar(double angle)
{
    SurfaceMesh mesh = box({1, 0.1, 0.2});
    const Quaternion turn(Eigen::AngleAxisd(angle - std::numbers::pi / 2, Vec3::UnitZ()));
    for (Vec3& vertex : mesh.vertices)
        vertex = turn * (vertex + Vec3(0.5, 0, 0)) + Vec3(4, 5, 6);
    RigidMotion bar(with_mass(mass_properties(mesh, 1), 3));
    bar.pin(Vec3(4, 5, 6), Vec3(0, 0, 1));
    return bar;
}

/// Its inertia about the pin [kg m^2], by Steiner's theorem.
const double bar_about_end = 3 * ((1 + 0.01) / 12 + 0.25);

void move(RigidMotion& motion, double dt)
{
    motion.predict(Vec3(0, -earth, 0), dt);
    motion.commit(dt);
}

/// The time of a whole swing from rest at this angle, between the moments at which the bar is lowest and
/// swings forwards [s].
double measured_period(double angle, double dt)
{
    RigidMotion bar = hanging_bar(angle);
    double first = -1, before = bar.centre().x() - 4;
    for (int step = 1;; ++step) {
        move(bar, dt);
        const double now = bar.centre().x() - 4;
        if (before < 0 && now >= 0) {
            const double passed = dt * (step - now / (now - before));
            if (first >= 0)
                return passed - first;
            first = passed;
        }
        before = now;
    }
}

}  // namespace

TEST_CASE("pinned bodies: a bar swings with the period of a physical pendulum, to the square of the step")
{
    for (const double angle : {0.01, 1.0, 2.5}) {
        CAPTURE(angle);
        // T = 4 sqrt(I / m g r) K(sin(angle / 2))
        const double formula = 4 * std::sqrt(bar_about_end / (3 * earth * 0.5)) *
                               std::comp_ellint_1(std::sin(angle / 2));
        const double coarse = std::abs(measured_period(angle, 0.01) / formula - 1),
                     fine = std::abs(measured_period(angle, 0.005) / formula - 1);
        CHECK(coarse < 2e-3);
        CHECK(fine < 0.3 * coarse);
    }
}

TEST_CASE(
    "pinned bodies: a swing neither dies nor grows, and the pin carries the weight and what bends the path")
{
    constexpr double dt = 0.001;
    RigidMotion bar = hanging_bar(std::numbers::pi / 2);
    double lowest = 5, of_pin = 0, spin = 0;
    for (int step = 0; step < 20000; ++step) {
        move(bar, dt);
        CHECK((bar.centre() - Vec3(4, 5, 6)).norm() == doctest::Approx(0.5).epsilon(1e-11));
        if (bar.centre().y() < lowest) {
            lowest = bar.centre().y();
            of_pin = bar.lock_impulse().y() / dt;
            spin = std::abs(bar.angular_velocity().z());
        }
    }
    // I w^2 / 2 = m g r at the lowest place, and there m (g + w^2 r) on the pin
    const double formula = 2 * 3 * earth * 0.5 / bar_about_end;
    CHECK(spin * spin == doctest::Approx(formula).epsilon(0.005));
    CHECK(of_pin == doctest::Approx(3 * (earth + formula * 0.5)).epsilon(0.005));
}

TEST_CASE(
    "pinned bodies: a hit turns the bar by its angular momentum about the pin, and at 2/3 of a thin one the pin feels nothing")
{
    RigidMotion bar = hanging_bar(0);
    const double sweet = bar_about_end / (3 * 0.5);  // the centre of percussion
    bar.predict(Vec3::Zero(), 0.01);
    bar.apply_impulse(Vec3(2, 0, 0), Vec3(4, 5 - sweet, 6));
    CHECK(bar.angular_velocity().z() == doctest::Approx(2 * sweet / bar_about_end).epsilon(1e-12));
    CHECK(bar.lock_impulse().norm() < 1e-12);
    bar.apply_impulse(Vec3(2, 0, 7), Vec3(4, 5, 6));  // on the pin itself
    CHECK(bar.angular_velocity().z() == doctest::Approx(2 * sweet / bar_about_end).epsilon(1e-12));
    CHECK((bar.lock_impulse() - Vec3(-2, 0, -7)).norm() < 1e-12);
    const Vec3 about_pin = bar.angular_momentum(Vec3(4, 5, 6)),
               about_other = bar.angular_momentum(Vec3(4, 7, 6));
    CHECK(about_pin.z() == doctest::Approx(2 * sweet));
    CHECK(about_other.z() == doctest::Approx(2 * sweet + 2 * bar.linear_momentum().x()));
    const double speed = 2 * sweet / bar_about_end;
    CHECK(bar.kinetic_energy() == doctest::Approx(bar_about_end * speed * speed / 2));
}

TEST_CASE("pinned bodies: a fast top on its tip goes round as the formula of steady precession says")
{
    // a disc of 2 kg, radius 0.3 and height 0.05, whose centre is 0.4 above the tip; its axis leans by 0.5
    constexpr double mass = 2, radius = 0.3, height = 0.05, lever = 0.4, lean = 0.5, spin = 120;
    const double about_axis = mass * radius * radius / 2,
                 about_tip = about_axis / 2 + mass * height * height / 12 + mass * lever * lever;
    const Mat3 axes = Eigen::AngleAxisd(lean, Vec3::UnitX()).toRotationMatrix();
    const Vec3 axis = axes.col(1), centre = lever * axis;
    const double side = about_axis / 2 + mass * height * height / 12;
    const MassProperties disc{mass, centre,
                              axes * Vec3(side, about_axis, side).asDiagonal() * axes.transpose()};
    // I cos(lean) W^2 - I3 w3 W + m g l = 0, with w3 the turning about the axis; the slow root
    const double a = about_tip * std::cos(lean), b = about_axis * spin, c = mass * earth * lever,
                 precession = 2 * c / (b + std::sqrt(b * b - 4 * a * c));
    const Vec3 across = precession * (Vec3::UnitY() - std::cos(lean) * axis);
    RigidMotion top(disc, Vec3::Zero(), spin * axis + across);
    top.pin(Vec3::Zero(), Vec3::Ones());
    constexpr double dt = 0.001;
    double turned = 0, highest = 0;
    Vec3 before = top.centre();
    for (int step = 0; step < 3000; ++step) {
        move(top, dt);
        const Vec3 now = top.centre();
        turned += std::atan2(before.z() * now.x() - before.x() * now.z(),
                             before.x() * now.x() + before.z() * now.z());
        highest = std::max(highest, std::abs(now.y() / (lever * std::cos(lean)) - 1));
        before = now;
    }
    CHECK(turned / 3 == doctest::Approx(precession).epsilon(1e-3));
    CHECK(highest < 1e-3);
}

TEST_CASE("pinned bodies: a pin at the centre is held translations, and a velocity of its own is refused")
{
    RigidMotion pinned(askew_brick(), Vec3::Zero(), Vec3(0, 2, 0)),
        held_one(askew_brick(), Vec3::Zero(), Vec3(0, 2, 0));
    pinned.pin(askew_brick().centre, Vec3(0, 1, 0));
    held_one.hold(held(Vec3::Ones(), Vec3(1, 0, 1)));
    for (int step = 0; step < 10; ++step)
        for (RigidMotion* one : {&pinned, &held_one}) {
            move(*one, 0.01);
            one->apply_momentum(Vec3(1, 2, 3), Vec3(4, 5, 6));
        }
    CHECK((pinned.angular_velocity() - held_one.angular_velocity()).norm() < 1e-12);
    RigidMotion moving(askew_brick(), Vec3(1, 0, 0));
    CHECK_THROWS_AS(moving.pin(Vec3::Zero(), Vec3::Ones()), InputError);
    RigidMotion turning(askew_brick(), Vec3::Zero(), Vec3(1, 0, 0));
    CHECK_THROWS_AS(turning.pin(Vec3::Zero(), Vec3(0, 1, 1)), InputError);
}
