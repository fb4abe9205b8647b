#include "common/rigid/free_rotation.hpp"
#include "common/experiments/verification/free_top.hpp"
#include "common/rigid/rigid_motion.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btEmptyShape.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

using namespace enduring;

namespace {

/// Euler's equations by fourth-order Runge and Kutta in body axes, the independent answer.
Vec3 euler_by_rk4(const Vec3& j, Vec3 w, double seconds, int steps)
{
    const auto rate = [&](const Vec3& u) -> Vec3 { return -u.cross(j.cwiseProduct(u)).cwiseQuotient(j); };
    const double h = seconds / steps;
    for (int i = 0; i < steps; ++i) {
        const Vec3 a = rate(w), b = rate(w + h / 2 * a), c = rate(w + h / 2 * b), d = rate(w + h * c);
        w += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return w;
}

/// Angular momentum of a box in a real Bullet world after some steps; the world the course does without.
btVector3 momentum_in_bullet_world(int flag, const btVector3& inertia, const btVector3& spin, int steps,
                                   double dt)
{
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity({0, 0, 0});
    btEmptyShape shape;
    btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &shape, inertia));
    body.setFlags(flag);
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setAngularVelocity(spin);
    world.addRigidBody(&body);
    for (int i = 0; i < steps; ++i)
        world.stepSimulation(dt, 0);
    const btMatrix3x3 turned = body.getWorldTransform().getBasis();
    const btVector3 momentum = turned * (inertia * (body.getAngularVelocity() * turned));
    world.removeRigidBody(&body);
    return momentum;
}

}  // namespace

TEST_CASE(
    "free rotation: a step keeps energy and the size of the momentum for any body and any turn below a radian")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> moment(0.1, 1.0), component(-1.0, 1.0), turn(1e-6, 1.0);
    for (int i = 0; i < 2000; ++i) {
        Vec3 j(moment(random), moment(random), moment(random));
        j.z() = std::min(j.z(), j.x() + j.y());  // no body has a moment above the sum of the other two
        const Vec3 w0 = Vec3(component(random), component(random), component(random)).normalized() *
                        turn(random);
        const Vec3 w1 = freely_turned(j, w0, 1.0);
        CAPTURE(j.transpose());
        CAPTURE(w0.transpose());
        const double energy = w0.dot(j.cwiseProduct(w0));
        CHECK(std::abs(w1.dot(j.cwiseProduct(w1)) - energy) <= 1e-13 * energy);
        CHECK(std::abs(j.cwiseProduct(w1).norm() - j.cwiseProduct(w0).norm()) <=
              1e-13 * j.cwiseProduct(w0).norm());
        // It is a step of Euler's equations, not one that keeps everything by standing still.
        const Vec3 change = -w0.cross(j.cwiseProduct(w0)).cwiseQuotient(j);
        CHECK((w1 - w0 - change).norm() <= 20 * w0.squaredNorm() * w0.norm() / j.minCoeff());
    }
}

TEST_CASE("free rotation: the error against Runge and Kutta falls with the square of the step")
{
    const Vec3 j(0.05, 0.17, 0.20), start(0.5, 5, 0);
    const double seconds = 1.0;
    const Vec3 exact = euler_by_rk4(j, start, seconds, 20000);
    std::array<double, 3> error{};
    for (std::size_t level = 0; level < error.size(); ++level) {
        const int steps = 100 << level;
        Vec3 w = start;
        for (int i = 0; i < steps; ++i)
            w = freely_turned(j, w, seconds / steps);
        error[level] = (w - exact).norm();
    }
    CAPTURE(error[0]);
    CHECK(error[0] < 0.1);
    CHECK(error[0] / error[1] == doctest::Approx(4).epsilon(0.05));
    CHECK(error[1] / error[2] == doctest::Approx(4).epsilon(0.05));
}

TEST_CASE("free rotation: a spin about a principal axis stays what it is")
{
    const Vec3 j(0.05, 0.17, 0.20);
    for (int axis = 0; axis < 3; ++axis)
        CHECK((freely_turned(j, 3 * Vec3::Unit(axis), 0.1) - 3 * Vec3::Unit(axis)).norm() <= 1e-15);
}

TEST_CASE("free top: Bullet's own steps drift by more than 1% in 10 s at 240 Hz, ours by rounding")
{
    for (const TopMethod method :
         {TopMethod::bullet_explicit, TopMethod::bullet_implicit_world, TopMethod::bullet_implicit_body}) {
        CAPTURE(name_of(method));
        CHECK(top_drift(method, 10, 240).energy > 0.01);
        CHECK(top_drift(method, 10, 240).momentum > 0.01);
    }
    CHECK(top_drift(TopMethod::bullet_kept, 10, 240).momentum > 0.01);
    CHECK(top_drift(TopMethod::ours, 10, 240).energy < 1e-12);
    CHECK(top_drift(TopMethod::ours, 10, 240).momentum < 1e-12);
}

TEST_CASE("free top: our top does tumble over")
{
    MassProperties box;
    box.mass = 1;
    box.inertia = Vec3(0.05, 0.17, 0.20).asDiagonal() * Mat3(Mat3::Identity() / 12);
    RigidMotion top(box, Vec3::Zero(), Vec3(0.05, 5, 0));
    const Vec3 axis_in_body = top.pose().orientation.conjugate() * Vec3::UnitY();
    double lowest = 1;
    for (int i = 0; i < 2400; ++i) {
        top.predict(Vec3::Zero(), 1.0 / 240);
        top.commit(1.0 / 240);
        lowest = std::min(lowest, (top.pose().orientation * axis_in_body).y());
    }
    CHECK(lowest < -0.9);
}

TEST_CASE("free top: the drift charged to Bullet is that of a real Bullet world")
{
    const btVector3 inertia(0.05 / 12, 0.17 / 12, 0.20 / 12), spin(0.05, 5, 0);
    const auto momentum_lost = [&](int flag) {
        const btVector3 first = inertia * spin;
        double lost = 0;
        for (int steps = 1; steps <= 480; steps += 7) {
            const btVector3 now = momentum_in_bullet_world(flag, inertia, spin, steps, 1.0 / 240);
            lost = std::max(lost, (now - first).length() / first.length());
        }
        return lost;
    };
    const double in_body = top_drift(TopMethod::bullet_implicit_body, 2, 240).momentum;
    const double without = top_drift(TopMethod::bullet_kept, 2, 240).momentum;
    CHECK(momentum_lost(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY) == doctest::Approx(in_body).epsilon(0.02));
    CHECK(momentum_lost(0) == doctest::Approx(without).epsilon(0.02));
}
