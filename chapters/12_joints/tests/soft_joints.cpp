#include "chapters/12_joints/experiments/machine.hpp"
#include "chapters/12_joints/solver.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace enduring;

namespace {

constexpr double gravity = 9.81, dense = std::numeric_limits<double>::infinity(), whole = 0;

/// A soft cube of 0.2 m and 2 kg, the middle of whose top is the origin, and what else is given.
Scene scene_with(const std::string& bodies, const std::string& joints, const std::string& more = "",
                 const std::string& brake = "2")
{
    return read_scene(R"({"name": "soft", "dt": 0.01, "duration": 1, )" + more + R"("bodies": [
      {"name": "cube", "type": "deformable", "shape": {"bar": {"size": [0.2, 0.2, 0.2], "cells": [2, 2, 2]}},
       "mass": 2, "young": 5e4, "poisson": 0.3, "rayleigh": {"mass": )" +
                          brake + R"(, "stiffness": 0.02}, "basis": "linear", "position": [0, -0.1, 0]})" +
                          bodies + R"(], "joints": [)" + joints + "]}",
                      "", "soft.json", {{"/nowhere"}});
}

const std::string ball_at_top = R"({"name": "nail", "type": "ball", "a": "cube", "at": [0, 0, 0]})",
                  rod_and_box =
                      R"(, {"name": "box", "type": "rigid", "shape": {"box": {"size": [0.1, 0.1, 0.1]}},
       "mass": 1, "position": [0.3, 0.05, 0.02], "velocity": [1, 2, 0], "angular_velocity": [0, 3, 1]})",
                  no_gravity = R"("gravity": [0, 0, 0], )";

/// Takes steps, and calls after each.
template <class After>
void run(Scene& scene, double duration, double sparse_operation, const After& after)
{
    ImplicitSettings settings;
    settings.sparse_operation = sparse_operation;
    const Solver solver = chapter12_solver(scene.contact, settings);
    Contacts contacts;
    for (long step = std::lround(duration / scene.dt); step > 0; --step) {
        advance(scene.world, contacts, solver, scene.dt);
        after();
    }
}

/// The largest error of all joints over a run.
double worst_of(Scene& scene, double duration, double sparse_operation = ImplicitSettings{}.sparse_operation)
{
    double worst = 0;
    run(scene, duration, sparse_operation, [&] {
        for (const Joint& joint : scene.world.joints)
            worst = std::max(worst, chapter12::error_of(scene.world, joint));
    });
    return worst;
}

}  // namespace

TEST_CASE("soft joints: a soft cube hangs at a point of its surface, and the joint carries its weight")
{
    for (const double sparse_operation : {dense, whole}) {
        CAPTURE(sparse_operation);
        Scene scene = scene_with("", ball_at_top);
        CHECK(worst_of(scene, 4, sparse_operation) <= 1e-9);
        CHECK((scene.world.joints[0].force - Vec3(0, 2 * gravity, 0)).norm() <= 1e-6 * 2 * gravity);
        CHECK(scene.world.ended_badly == 0);
    }
}

TEST_CASE(
    "soft joints: a cube falls and swings the same, whether it enters by its held vertices or by all nodes")
{
    const auto centre = [](double sparse_operation) {
        Scene scene = scene_with("",
                                 R"({"name": "nail", "type": "ball", "a": "cube", "at": [0.1, 0, 0.03]})");
        CHECK(worst_of(scene, 0.5, sparse_operation) <= 1e-9);
        return scene.world.bodies[0]->centre();
    };
    const Vec3 one = centre(dense), other = centre(whole);
    CHECK((one - other).norm() <= 1e-5);
    CHECK((one - Vec3(0, -0.1, 0)).norm() > 0.05);
}

TEST_CASE(
    "soft joints: forces between a soft cube and a rigid box change neither momentum nor angular momentum")
{
    for (const char* const type : {"ball", "rod"}) {
        CAPTURE(type);
        const std::string to = type[0] == 'r' ? R"(, "at": [0.1, -0.05, 0.02], "to": [0.25, 0.05, 0.02]})"
                                              : R"(, "at": [0.1, -0.05, 0.02]})";
        Scene scene = scene_with(
            rod_and_box,
            R"({"name": "j", "a": "cube", "b": "box", "type": ")" + std::string(type) + "\"" + to, no_gravity,
            "0");
        const auto momenta = [&] {
            Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
            for (const auto& body : scene.world.bodies) {
                sum.head<3>() += body->linear_momentum();
                sum.tail<3>() += body->angular_momentum(Vec3::Zero());
            }
            return sum;
        };
        const Eigen::Matrix<double, 6, 1> start = momenta();
        CHECK(worst_of(scene, 0.5) <= 1e-9);
        CHECK((momenta() - start).head<3>().norm() <= 1e-9);
        CHECK((momenta() - start).tail<3>().norm() <= 1e-9);
        CHECK(scene.world.bodies[0]->linear_momentum().norm() > 0.1);
    }
}

TEST_CASE(
    "soft joints: a crank that moves as given leads the end of a soft bar, and gives the work that it needs")
{
    Scene scene = read_scene(
        R"({"name": "crank", "dt": 0.005, "duration": 1, "gravity": [0, 0, 0], "bodies": [
      {"name": "bar", "type": "deformable", "shape": {"bar": {"size": [0.6, 0.1, 0.1], "cells": [6, 1, 1]}},
       "mass": 1, "young": 1e6, "poisson": 0.3, "rayleigh": {"stiffness": 0.01}, "basis": "linear",
       "position": [0.5, 0, 0]},
      {"name": "crank", "type": "static", "shape": {"box": {"size": [0.5, 0.05, 0.05]}}, "position": [0, 0, 0.2],
       "motion": {"table": [{"time": 0}, {"time": 1, "turn": {"axis": [0, 0, 1], "angle_deg": 90}}]}}],
      "joints": [{"name": "pin", "type": "ball", "a": "bar", "b": "crank", "at": [0.2, 0, 0]}]})",
        "", "crank.json", {{"/nowhere"}});
    CHECK(worst_of(scene, 1) <= 1e-9);
    const JointPose pose = committed_pose(scene.world, scene.world.joints[0]);
    CHECK((pose.point_a - Vec3(0, 0.2, 0)).norm() <= 1e-9);
    const double gained = total_energy(scene.world).total();
    CHECK(gained > 0.001);
    CHECK(scene.world.driven >= gained);
    CHECK(scene.world.ended_badly == 0);
}

TEST_CASE("soft joints: a rod between two soft cubes carries the lower one, and the nail both")
{
    // a rod between two soft cubes reads six vertices
    Scene scene = scene_with(
        R"(, {"name": "other", "type": "deformable", "shape": {"bar": {"size": [0.2, 0.2, 0.2], "cells": [2, 2, 2]}},
       "mass": 2, "young": 5e4, "poisson": 0.3, "rayleigh": {"mass": 2, "stiffness": 0.02}, "basis": "linear",
       "position": [0.02, -0.6, 0.01]})",
        ball_at_top +
            R"(, {"name": "rod", "type": "rod", "a": "other", "b": "cube", "at": [0.03, -0.5, 0.02], "to": [0.02, -0.2, 0.03]})");
    CHECK(worst_of(scene, 6) <= 1e-9);
    CHECK(scene.world.joints[1].force.y() == doctest::Approx(2 * gravity).epsilon(1e-3));
    CHECK(scene.world.joints[0].force.y() == doctest::Approx(4 * gravity).epsilon(1e-3));
}
