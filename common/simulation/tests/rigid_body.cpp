#include "common/simulation/rigid_body.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/simulation/step.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

/// A brick of 2 x 1 x 0.5 m, turned and moved away from the origin, of 8 kg.
SurfaceMesh placed_brick()
{
    SurfaceMesh mesh = box({2, 1, 0.5});
    const Quaternion turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()));
    for (Vec3& vertex : mesh.vertices)
        vertex = turn * vertex + Vec3(3, 4, 5);
    return mesh;
}

RigidBody brick(const Vec3& velocity = Vec3::Zero(), const Vec3& spin = Vec3::Zero())
{
    const SurfaceMesh mesh = placed_brick();
    return RigidBody("brick", mesh, with_mass(mass_properties(mesh, 1.0), 8.0), velocity, spin);
}

}  // namespace

TEST_CASE("rigid body: its surface starts where the mesh lies")
{
    const SurfaceMesh mesh = placed_brick();
    const RigidBody body = brick();
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        CHECK((body.positions_t0()[i] - mesh.vertices[i]).norm() < 1e-14);
    CHECK(body.mass() == 8.0);
}

TEST_CASE("rigid body: free fall within the step is symplectic Euler, at every vertex")
{
    RigidBody body = brick({1, 0, 0});
    const std::vector<Vec3> start(body.positions_t0().begin(), body.positions_t0().end());
    const Vec3 gravity(0, -9.81, 0);
    const double dt = 0.02;
    for (int n = 1; n <= 10; ++n) {
        body.predict(gravity, dt);
        body.commit(dt);
    }
    // v_n = v_0 + n g dt; x_n = x_0 + n v_0 dt + n (n + 1) / 2 g dt^2.
    const Vec3 expected = 10 * dt * Vec3(1, 0, 0) + 55 * dt * dt * gravity;
    for (std::size_t i = 0; i < start.size(); ++i)
        CHECK((body.positions_t0()[i] - start[i] - expected).norm() < 1e-13);
}

TEST_CASE("rigid body: the predicted surface is the one that committing produces, also while it spins")
{
    RigidBody body = brick({0, 1, 0}, {3, -2, 5});
    body.predict({0, -9.81, 0}, 0.05);
    body.apply_impulse(3, {1, -2, 0.5});
    body.update_prediction(0.05);
    const std::vector<Vec3> predicted(body.positions_t1().begin(), body.positions_t1().end());
    body.commit(0.05);
    for (std::size_t i = 0; i < predicted.size(); ++i) {
        CHECK((body.positions_t0()[i] - predicted[i]).norm() < 1e-13);
        CHECK(body.positions_t1()[i] == body.positions_t0()[i]);
    }
    CHECK((predicted[1] - predicted[0]).norm() ==
          doctest::Approx((placed_brick().vertices[1] - placed_brick().vertices[0]).norm()));
}

TEST_CASE(
    "rigid body: an impulse changes the velocity at its vertex by the inverse mass there, and no position")
{
    RigidBody body = brick({0, 1, 0}, {0.3, -0.2, 0.5});
    const double dt = 0.01;
    body.predict(Vec3::Zero(), dt);
    for (const int vertex : {0, 3, 6}) {
        const std::vector<Vec3> before_t1(body.positions_t1().begin(), body.positions_t1().end());
        const Vec3 impulse(1, -2, 0.5), before = body.velocity(vertex);
        body.apply_impulse(vertex, impulse);
        CHECK((body.velocity(vertex) - before - body.inverse_mass(vertex) * impulse).norm() < 1e-13);
        CHECK(std::equal(before_t1.begin(), before_t1.end(), body.positions_t1().begin()));
    }
}

TEST_CASE("rigid body: the inverse mass of a box's corner is the textbook's 3x3 matrix")
{
    // Upright box a x b x c of mass m: inertia m/12 (b^2+c^2, a^2+c^2, a^2+b^2), lever r = half the sizes.
    const double m = 8, a = 2, b = 1, c = 0.5;
    const SurfaceMesh mesh = box({a, b, c});
    const RigidBody body("box", mesh, with_mass(mass_properties(mesh, 1.0), m));
    for (int vertex = 0; vertex < 8; ++vertex) {
        const Vec3 r = mesh.vertices[vertex];
        Mat3 cross;
        cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
        const Vec3 inertia = m / 12 * Vec3(b * b + c * c, a * a + c * c, a * a + b * b);
        const Mat3 expected = Mat3::Identity() / m - cross * inertia.cwiseInverse().asDiagonal() * cross;
        CHECK((body.inverse_mass(vertex) - expected).norm() < 1e-13);
    }
}

TEST_CASE("rigid body: impulses give it exactly their linear and angular momentum")
{
    RigidBody body = brick();
    body.predict(Vec3::Zero(), 0.01);
    const Vec3 about(0.5, -1, 2);
    Vec3 linear = body.linear_momentum(), angular = body.angular_momentum(about);
    for (const auto& [vertex, impulse] :
         {std::pair<int, Vec3>{0, {1, 2, 3}}, {5, {-2, 0.5, 1}}, {2, {0, -4, 0.25}}}) {
        linear += impulse;
        angular += (body.positions_t0()[vertex] - about).cross(impulse);
        body.apply_impulse(vertex, impulse);
    }
    CHECK((body.linear_momentum() - linear).norm() < 1e-13);
    CHECK((body.angular_momentum(about) - angular).norm() < 1e-12);
}

TEST_CASE("rigid body: potential energy turns into kinetic energy in free fall")
{
    RigidBody body = brick();
    const Vec3 gravity(0, -9.81, 0);
    CHECK(body.energy(gravity).gravitational == doctest::Approx(8 * 9.81 * 4));
    const double before = body.energy(gravity).total();
    for (int n = 0; n < 1000; ++n) {
        body.predict(gravity, 1e-4);
        body.commit(1e-4);
    }
    // Symplectic Euler lags by m g^2 dt t / 2.
    CHECK(body.energy(gravity).total() - before ==
          doctest::Approx(-8 * 9.81 * 9.81 * 1e-4 * 0.1 / 2).epsilon(1e-6));
}

namespace {

/// Checks that contact sees a body with held directions as every other impulse does.
/// @return  the response of its vertex 3
Mat3 response_in_contact(RigidBody& body)
{
    body.predict(Vec3::Zero(), 0.01);
    const std::vector<int> touched{3};
    const ContactMass of = body.contact_mass(touched);
    CHECK((of.mass * of.response - Eigen::MatrixXd::Identity(6, 6)).norm() < 1e-12);
    const VertexMotion motion = body.contact_motion(touched, 0, 0);
    const Mat3 response = motion.rate * of.response * motion.rate.transpose();
    CHECK((response - body.inverse_mass(3)).norm() < 1e-12);

    const Vec3 before = body.velocity(3), impulse(1, -2, 3);
    const auto trial = body.begin_trial();
    trial->push(3, impulse);
    const Vec3 tried = trial->velocity(3);
    body.apply_contact_impulse(touched, motion.rate.transpose() * impulse);
    CHECK((body.velocity(3) - before - response * impulse).norm() < 1e-12);
    CHECK((body.velocity(3) - tried).norm() < 1e-12);
    return response;
}

}  // namespace

TEST_CASE("rigid body: with held directions its contact mass and motion are those of the free ones")
{
    for (const Vec3& turns : {Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 0)}) {
        CAPTURE(turns.transpose());
        RigidBody body = brick();
        body.hold({Vec3(1, 0, 1), turns});
        const Mat3 response = response_in_contact(body);
        CHECK((response.row(1).norm() < 1e-14) == (turns.x() == 0));  // y moves by a turn about x alone
        CHECK(body.linear_momentum().y() == 0);
    }
}

TEST_CASE("rigid body: directions that are held along axes of its own are left out of contact, and no others")
{
    const Mat3 axes = Quaternion(Eigen::AngleAxisd(0.6, Vec3(2, -1, 2) / 3)).toRotationMatrix();
    for (const Vec3& turns : {Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 0)}) {
        CAPTURE(turns.transpose());
        RigidBody body = brick();
        body.hold({Vec3(1, 0, 1), turns, axes});
        response_in_contact(body);
        CHECK(std::abs(axes.col(1).dot(body.linear_momentum())) < 1e-12);
    }
}
