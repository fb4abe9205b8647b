#include "common/rigid/rigid_motion.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace enduring;

namespace {

const Vec3 sides(0.4, 0.2, 0.1);

/// A box of 2 kg whose axes lie askew in the world.
MassProperties askew_box()
{
    const Vec3 s = sides.cwiseAbs2();
    const Mat3 axes = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    const Mat3 moments = (2.0 / 12 * Vec3(s.y() + s.z(), s.z() + s.x(), s.x() + s.y())).asDiagonal();
    return {2.0, Vec3(0.3, -1, 2), axes * moments * axes.transpose()};
}

void step(RigidMotion& body, double dt, const Vec3& gravity = Vec3::Zero())
{
    body.predict(gravity, dt);
    body.commit(dt);
}

}  // namespace

TEST_CASE("rigid motion: free fall gives the answer of symplectic Euler, not that of the thesis' 3.5")
{
    const Vec3 gravity(0, -9.81, 0), v0(1, 2, -3);
    const double dt = 0.01;
    RigidMotion body(askew_box(), v0);
    const int n = 100;
    for (int i = 0; i < n; ++i)
        step(body, dt, gravity);
    // x_n = x_0 + n dt v_0 + g dt^2 (1 + 2 + ... + n)
    const Vec3 expected = askew_box().centre + n * dt * v0 + gravity * dt * dt * (n * (n + 1) / 2);
    CHECK((body.pose().position - expected).norm() <= 1e-12);
    CHECK((body.velocity() - (v0 + n * dt * gravity)).norm() <= 1e-12);
    const Vec3 printed = askew_box().centre + n * dt * v0 + 0.5 * gravity * (n * dt) * (n * dt);
    CHECK((body.pose().position - printed).norm() > 0.04);  // half a step of falling at 9.8 m/s
}

TEST_CASE("rigid motion: a body without a push keeps its pose to the bit")
{
    RigidMotion body(askew_box());
    const Pose before = body.pose();
    for (int i = 0; i < 100; ++i)
        step(body, 0.01);
    CHECK(body.pose().position == before.position);
    CHECK((body.pose().orientation.coeffs() - before.orientation.coeffs()).norm() <= 1e-14);
}

TEST_CASE("rigid motion: an impulse off centre moves and turns as mass and inertia say")
{
    RigidMotion body(askew_box());
    const Vec3 point = askew_box().centre + Vec3(0.1, 0.05, -0.2), impulse(0.3, -0.7, 0.2);
    const Vec3 lever_arm = point - askew_box().centre;
    const Vec3 before = body.velocity_at(point);
    const Mat3 inverse_mass = body.inverse_mass_at(point);
    body.apply_impulse(impulse, point);

    CHECK((body.velocity() - impulse / 2.0).norm() <= 1e-15);
    const Vec3 spin = askew_box().inertia.inverse() * lever_arm.cross(impulse);
    CHECK((body.angular_velocity() - spin).norm() <= 1e-12 * spin.norm());
    CHECK((body.velocity_at(point) - before - inverse_mass * impulse).norm() <= 1e-12);
    CHECK((body.angular_momentum(Vec3::Zero()) - point.cross(impulse)).norm() <= 1e-15);
    CHECK(body.kinetic_energy() == doctest::Approx(0.5 * impulse.dot(inverse_mass * impulse)).epsilon(1e-12));
}

TEST_CASE(
    "errata: an impulse is what mass times velocity changes by, not what it is, as (3.9) prints, and (3.10) of the turn")
{
    const Vec3 centre = askew_box().centre, off_centre = centre + Vec3(0.1, 0.05, -0.2),
               impulse(0.3, -0.7, 0.2);
    for (const Vec3& velocity : {Vec3(0, 0, 0), Vec3(1, 2, -1)}) {
        RigidMotion body(askew_box(), velocity, velocity);
        const Mat3 inertia = body.inverse_inertia().inverse();
        const Vec3 v0 = body.velocity(), omega0 = body.angular_velocity(),
                   twist = (off_centre - centre).cross(impulse);
        body.apply_impulse(impulse, off_centre);
        CHECK((2.0 * (body.velocity() - v0) - impulse).norm() <= 1e-14);
        CHECK((inertia * (body.angular_velocity() - omega0) - twist).norm() <= 1e-14);
        const bool at_rest = velocity.isZero();  // there alone the printed forms hold
        CHECK(((2.0 * body.velocity() - impulse).norm() <= 1e-14) == at_rest);
        CHECK(((inertia * body.angular_velocity() - twist).norm() <= 1e-14) == at_rest);
    }
}

TEST_CASE("rigid motion: an impulse through the centre does not turn")
{
    RigidMotion body(askew_box());
    body.apply_impulse({1, 2, 3}, body.pose().position);
    CHECK(body.angular_velocity().norm() == 0);
}

TEST_CASE("rigid motion: impulses in mid-flight change the angular momentum by point x impulse, and it stays")
{
    const double dt = 0.01;
    RigidMotion body(askew_box(), {0.5, 0, 1}, {3, -4, 5});
    Vec3 expected = body.angular_momentum(Vec3::Zero());
    for (int i = 0; i < 200; ++i) {
        body.predict(Vec3::Zero(), dt);
        const Vec3 point = body.pose().to_world(0.5 * sides), impulse(0.01 * std::sin(i), 0.02, -0.01);
        body.apply_impulse(impulse, point);
        expected += point.cross(impulse);
        body.commit(dt);
    }
    CHECK((body.angular_momentum(Vec3::Zero()) - expected).norm() <= 1e-12);
}

TEST_CASE("rigid motion: the predicted pose is the one that commit produces, pushed or not")
{
    const double dt = 0.02;
    RigidMotion body(askew_box(), {1, 0, 0}, {9, -6, 4});
    body.predict({0, -9.81, 0}, dt);
    const Pose unpushed = body.predicted_pose(dt);
    body.apply_impulse({0.2, 0.1, 0}, body.pose().to_world(sides));
    const Pose pushed = body.predicted_pose(dt);
    CHECK((unpushed.position - pushed.position).norm() > 1e-4);
    CHECK(unpushed.orientation.angularDistance(pushed.orientation) > 1e-4);
    body.commit(dt);
    CHECK(body.pose().position == pushed.position);
    CHECK(body.pose().orientation.angularDistance(pushed.orientation) <= 1e-15);
}

TEST_CASE("rigid motion: a turn is the exponential map, however far")
{
    // A sphere's inertia: the angular velocity is constant, the turn after dt is |w| dt about w.
    MassProperties ball;
    ball.mass = 1;
    ball.inertia = 0.4 * Mat3::Identity();
    const Vec3 axis = Vec3(1, 2, 2) / 3;
    for (const double angle : {0.0, 1e-300, 1e-9, 1e-3, 0.1, 0.7, 0.8, 1.6, 3.0, 6.0}) {
        CAPTURE(angle);
        const double dt = 0.1;
        RigidMotion body(ball, Vec3::Zero(), angle / dt * axis);
        const Quaternion start = body.pose().orientation;
        body.predict(Vec3::Zero(), dt);
        const Quaternion turned = body.predicted_pose(dt).orientation * start.conjugate();
        CHECK(turned.angularDistance(Quaternion(Eigen::AngleAxisd(angle, axis))) <= 1e-14);
    }
}

TEST_CASE("rigid motion: to_body undoes to_world")
{
    RigidMotion body(askew_box(), {1, 0, 0}, {9, -6, 4});
    step(body, 0.1);
    const Vec3 point(0.3, 0.1, -2);
    CHECK((body.pose().to_world(body.pose().to_body(point)) - point).norm() <= 1e-14);
}

TEST_CASE("rigid motion: what cannot move as a body is refused")
{
    MassProperties p = askew_box();
    CHECK_THROWS_AS(RigidMotion(p, Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0)), InputError);
    p.mass = 0;
    CHECK_THROWS_AS(RigidMotion{p}, InputError);
    p = askew_box();
    p.inertia(0, 0) = -1;
    CHECK_THROWS_AS(RigidMotion{p}, InputError);
}
