#include "chapters/07_implicit_contact/force_element.hpp"
#include "chapters/07_implicit_contact/pair_law.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <string>

using namespace enduring;

namespace {

constexpr double gravity = 9.81;

/// A cube on the ground, whose weight pulls along the ground as on a slope.
/// @param slope     tangent of the angle
/// @param towards   along the ground, unit length
Scene cube_on_slope(double slope, const Vec3& towards, const std::string& friction,
                    const std::string& of_ground, const std::string& of_cube = "")
{
    Scene scene = read_scene(R"({"name": "slope", "dt": 0.01, "duration": 1, "contact": {"friction": )" +
                                 friction + R"(}, "planes": [{"name": "ground")" + of_ground +
                                 R"(}], "bodies": [
      {"name": "cube", "type": "rigid", "shape": {"box": {"size": [0.5, 0.1, 0.3]}}, "mass": 2, "position": [0, 0.05, 0])" +
                                 of_cube + "}]}",
                             "", "slope.json", {{"/nowhere"}});
    scene.world.gravity = gravity / std::hypot(1, slope) * (slope * towards - Vec3::UnitY());
    return scene;
}

void run(Scene& scene, double duration)
{
    const Solver solver = chapter07_solver(scene.contact);
    Contacts contacts;
    for (long step = std::lround(duration / scene.dt); step > 0; --step)
        advance(scene.world, contacts, solver, scene.dt);
}

const std::string rubs = R"({"model": "mass_splitting", "mu_s": 0.5, "mu_d": 0.5})",
                  grain_along_x = R"(, "grain": {"along": [1, 0, 0], "across": 0.4})",
                  quarter_turn = R"(, "rotation": {"axis": [0, 1, 0], "angle_deg": 90})";

/// A ball of 1 m and 1 kg that stands on one of its vertices, so that its patch is that of a law alone.
struct Ball {
    Scene scene;

    Ball(double mu, const SurfaceLaws& laws, const Vec3& spin = Vec3::Zero(), double dt = 0.01)
    {
        SurfaceMesh mesh = sphere(1, 1);
        const Quaternion turn = Quaternion::FromTwoVectors(mesh.vertices[0], -Vec3::UnitY());
        for (Vec3& vertex : mesh.vertices)
            vertex = turn * vertex + Vec3::UnitY();
        scene.dt = dt;
        scene.contact.friction = MassSplitting{.mu_s = mu, .mu_d = mu};
        scene.contact.surface_laws = laws;
        scene.world.bodies.push_back(std::make_unique<RigidBody>(
            "ball", mesh, with_mass(mass_properties(mesh, 1), 1), Vec3::Zero(), spin));
    }
    void put_on_plane() { scene.world.planes.push_back({"ground"}); }
    const RigidMotion& motion() const
    {
        return dynamic_cast<const RigidBody&>(*scene.world.bodies[0]).motion();
    }
};

/// A round prism about z with this many sides.
SurfaceMesh wheel(double radius, int sides)
{
    SurfaceMesh mesh;
    for (const double z : {-0.1, 0.1}) {
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            mesh.vertices.emplace_back(radius * std::sin(angle), radius * std::cos(angle), z);
        }
        mesh.vertices.emplace_back(0, 0, z);
    }
    const int back = sides, front = 2 * sides + 1;  // the middles; the front ring begins behind the first
    for (int i = 0; i < sides; ++i) {
        const int next = (i + 1) % sides, i_front = sides + 1 + i, next_front = sides + 1 + next;
        mesh.faces.push_back({back, i, next});
        mesh.faces.push_back({front, next_front, i_front});
        mesh.faces.push_back({i, i_front, next_front});
        mesh.faces.push_back({i, next_front, next});
    }
    return mesh;
}

}  // namespace

TEST_CASE(
    "surface laws: what a pair pushes falls with the velocity by its Hessian, with a grain and a film, too")
{
    PairLaw law;
    law.normal = Vec3(1, 2, -2) / 3;
    law.depth_t0 = -0.001;
    law.stiffness = 1e4;
    law.mu = 0.5;
    law.lagged_normal_impulse = 0.1;
    law.stretch = 1e-4 * law.normal.unitOrthogonal();
    law.viscous = 0.3;
    const Vec3 side = law.normal.cross(Vec3::UnitX()).normalized();
    law.grain = Mat3::Identity() - 0.6 * side * side.transpose();
    law.has_grain = true;
    const StepLaw step{1, 0.01};
    for (const double size : {0.001, 0.5, 2.0}) {  // one that holds, and two that slip
        const Vec3 velocity = size * Vec3(0.3, -0.2, 0.5);
        const PairPush push = pushed(law, velocity, step);
        CHECK(push.slips == (size > 0.01));
        Mat3 differences;
        for (int i = 0; i < 3; ++i)
            differences.col(i) = (pushed(law, velocity - 1e-7 * Vec3::Unit(i), step).total() -
                                  pushed(law, velocity + 1e-7 * Vec3::Unit(i), step).total()) /
                                 2e-7;
        const Mat3 hessian = hessian_of(law, push, step);
        CHECK((hessian - differences).norm() <= 1e-5 * hessian.norm());
        CHECK(Eigen::SelfAdjointEigenSolver<Mat3>(hessian).eigenvalues().minCoeff() >= -1e-12);
    }
}

TEST_CASE(
    "surface laws: a round bound is the same in all directions of its plane, and its Hessian is minus its derivative")
{
    ElementLaw law;
    law.is_round = true;
    law.axes << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1;
    law.lines = {LineLaw{0, 2, -0.5, 0.5}, LineLaw{0, 2, -0.5, 0.5}, LineLaw{0, 3, -0.1, 0.1}};
    for (const double angle : {0.0, 0.5, 0.785, 2.0})
        CHECK(law.impulse(Vec3(std::cos(angle), std::sin(angle), 0)).norm() ==
              doctest::Approx(0.5).epsilon(1e-12));
    for (const Vec3& velocity : {Vec3(0.1, -0.1, 0.01), Vec3(0.4, 0.5, 1.75)}) {
        Mat3 differences;
        for (int i = 0; i < 3; ++i)
            differences.col(i) = (law.impulse(velocity - 1e-6 * Vec3::Unit(i)) -
                                  law.impulse(velocity + 1e-6 * Vec3::Unit(i))) /
                                 2e-6;
        CHECK((law.hessian(velocity) - differences).norm() <= 1e-8);
    }
}

TEST_CASE(
    "surface laws: on a grain a cube slides from another slope on along it than across it, on ground and cube alike")
{
    const auto speed = [](double slope, const Vec3& towards, const std::string& ground,
                          const std::string& cube) {
        Scene scene = cube_on_slope(slope, towards, rubs, ground, cube);
        run(scene, 0.5);
        return scene.world.bodies[0]->mean_velocity().norm();
    };
    const auto sliding = [](double slope, double mu) {
        return 0.5 * gravity / std::hypot(1, slope) * (slope - mu);
    };
    const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
    for (const auto& [along, across, ground, cube] :
         {std::tuple(x, z, grain_along_x, std::string()), std::tuple(x, z, std::string(), grain_along_x),
          std::tuple(z, x, std::string(), grain_along_x + quarter_turn)}) {
        CAPTURE(ground);
        CHECK(speed(0.49, along, ground, cube) <= 1e-5);
        CHECK(speed(0.55, along, ground, cube) == doctest::Approx(sliding(0.55, 0.5)).epsilon(0.01));
        CHECK(speed(0.196, across, ground, cube) <= 1e-5);
        CHECK(speed(0.25, across, ground, cube) == doctest::Approx(sliding(0.25, 0.2)).epsilon(0.01));
    }
}

TEST_CASE("surface laws: what slips on a grain is braked as the ellipse of most dissipation says")
{
    Scene scene = cube_on_slope(0, Vec3::UnitX(), rubs, grain_along_x, R"(, "velocity": [1, 0, 1])");
    scene.dt = 0.001;
    run(scene, 0.01);
    const Vec3 change = scene.world.bodies[0]->mean_velocity() - Vec3(1, 0, 1);
    const double most = 0.5 * gravity * 0.01 / std::hypot(1, 0.4);  // D^2 u over |D u|
    CHECK(change.x() == doctest::Approx(-most).epsilon(0.01));
    CHECK(change.z() == doctest::Approx(-0.16 * most).epsilon(0.01));
}

TEST_CASE(
    "surface laws: on a film a cube comes to the speed at which friction carries its weight along the slope")
{
    for (const double mu : {0.0, 0.1}) {
        CAPTURE(mu);
        Scene scene = cube_on_slope(
            0.3, Vec3::UnitX(),
            R"({"model": "mass_splitting", "mu_s": )" + std::to_string(mu) + R"(, "viscous": 0.5})", "");
        run(scene, 4);
        CHECK(scene.world.bodies[0]->mean_velocity().x() == doctest::Approx((0.3 - mu) / 0.5).epsilon(1e-5));
    }
}

TEST_CASE("surface laws: a film brakes what is thrown by a part in each time, and holds nothing")
{
    Scene scene = cube_on_slope(0, Vec3::UnitX(), R"({"model": "none", "viscous": 0.2})", "",
                                R"(, "velocity": [0, 0, 3])");
    scene.dt = 0.001;
    run(scene, 0.5);
    CHECK(scene.world.bodies[0]->mean_velocity().z() ==
          doctest::Approx(3 * std::exp(-0.2 * gravity * 0.5)).epsilon(0.002));
}

TEST_CASE("surface laws: a ball rests on a slope below rolling / R and rolls above it")
{
    for (const double slope : {0.19, 0.21}) {
        Ball ball(1, {0, 0.2, 0});
        ball.put_on_plane();
        ball.scene.world.gravity = gravity / std::hypot(1, slope) *
                                   Vec3(slope / std::numbers::sqrt2, -1, slope / std::numbers::sqrt2);
        run(ball.scene, 0.5);
        CHECK((ball.motion().angular_velocity().norm() <= 1e-4) == (slope < 0.2));
        CHECK(ball.scene.world.ended_badly == 0);
    }
}

TEST_CASE("surface laws: a wheel that rolls slows down by 2/3 g rolling / R")
{
    const double radius = 0.5, rolling = 0.02, speed = 1;
    SurfaceMesh mesh = wheel(radius, 400);
    Scene scene;
    scene.dt = 0.005;
    scene.contact.friction = MassSplitting{.mu_s = 0.5, .mu_d = 0.5};
    scene.contact.surface_laws.rolling = rolling;
    scene.world.planes.push_back({"ground", Vec3(0, -radius, 0)});
    scene.world.bodies.push_back(std::make_unique<RigidBody>("wheel", mesh, mass_properties(mesh, 100),
                                                             Vec3(speed, 0, 0), Vec3(0, 0, -speed / radius)));
    run(scene, 1);
    CHECK(scene.world.bodies[0]->mean_velocity().x() ==
          doctest::Approx(speed - 2.0 / 3 * gravity * rolling / radius).epsilon(0.01));
}

TEST_CASE("surface laws: a ball that spins on a patch stops in the time of its formula")
{
    const double mu = 0.4, patch = 0.3, speed = 4;
    Ball ball(mu, {0, 0, patch}, Vec3(0, speed, 0));
    ball.put_on_plane();
    const double inertia = 1 / ball.motion().inverse_inertia()(1, 1),
                 time = inertia * speed / (2.0 / 3 * mu * patch * gravity);
    run(ball.scene, 0.5);
    CHECK(ball.motion().angular_velocity().y() == doctest::Approx(speed * (1 - 0.5 / time)).epsilon(1e-6));
    run(ball.scene, time);
    CHECK(ball.motion().angular_velocity().norm() <= 1e-5);
}

TEST_CASE("surface laws: a turntable takes a ball along by its patch, and its work is booked")
{
    Ball ball(0.4, {0, 0, 0.3});
    SurfaceMesh table = sphere(1, 0);
    table.vertices = {Vec3(-5, 0, -5), Vec3(-5, 0, 5), Vec3(5, 0, 5), Vec3(5, 0, -5)};
    table.faces = {{0, 1, 2}, {0, 2, 3}};
    ball.scene.world.bodies.push_back(std::make_unique<DrivenBody>(
        "table", table, Vec3::Zero(), GivenMotion::steady(Vec3::Zero(), Vec3(0, 2, 0))));
    run(ball.scene, 1.5);
    CHECK(ball.motion().angular_velocity().y() == doctest::Approx(2).epsilon(1e-4));
    CHECK(ball.scene.world.thrown_away == 0);
    CHECK(ball.scene.world.driven >= ball.motion().kinetic_energy() * (1 - 1e-6));
}
