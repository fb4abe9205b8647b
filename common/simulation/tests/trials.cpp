#include "common/scenes/scene_reader.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

/// One body of the kind, in the middle of a tumbling step, and three of its vertices.
std::unique_ptr<Body> body_in_motion(const std::string& kind, double dt)
{
    const bool held = kind == "rigid held";
    const std::string what =
        held
            ? R"("type": "rigid", "shape": {"box": {"size": [1, 0.5, 0.4]}}, "mass": 3, "angular_velocity": [0.3, 0, 2],
                  "locked": {"translation": ["x"], "rotation": ["y"]})"
        : kind == "rigid"
            ? R"("type": "rigid", "shape": {"box": {"size": [1, 0.5, 0.4]}}, "mass": 3)"
            : R"("type": "deformable", "shape": {"bar": {"size": [1, 0.2, 0.2], "cells": [4, 1, 1]}}, "density": 100, "young": 1e6,
             "poisson": 0.3, "basis": ")" +
                  std::string(kind.find("quadratic") == std::string::npos ? "linear" : "quadratic") +
                  R"(", "impulse_response": ")" +
                  std::string(kind.find("implicit") == std::string::npos ? "lumped" : "implicit") + "\"";
    Scene scene = read_scene(
        R"({"name": "s", "dt": 0.01, "duration": 1, "bodies": [{"name": "b", "position": [3, -2, 1], )" +
            std::string(held ? "" : R"("angular_velocity": [0.3, 0.5, 2], )") + what + "}]}",
        "", "s.json", {});
    std::unique_ptr<Body> body = std::move(scene.world.bodies[0]);
    for (int step = 0; step < 30; ++step) {
        body->predict(Vec3::Zero(), dt);
        body->commit(dt);
    }
    body->predict(Vec3::Zero(), dt);
    return body;
}

}  // namespace

TEST_CASE("trials: what is tried is what would happen, and nothing happens")
{
    const double dt = 0.01;
    for (const std::string kind : {"rigid", "rigid held", "lumped linear", "lumped quadratic",
                                   "implicit linear", "implicit quadratic"}) {
        CAPTURE(kind);
        const auto body = body_in_motion(kind, dt);
        const std::vector<std::pair<int, Vec3>> impulses{
            {0, {0.5, -1, 2}}, {3, {1, 0.2, 0}}, {7, {0, 0.4, -0.3}}, {3, {0, 0, 0.6}}};
        const std::vector<int> asked{0, 3, 7, 5};
        body->begin_trial()->push(2, {5, 5, 5});  // gone with its trial
        const std::unique_ptr<Trial> trial = body->begin_trial();
        std::vector<Vec3> before, tried;
        for (const auto& [vertex, impulse] : impulses)
            trial->push(vertex, impulse);
        for (const int vertex : asked) {
            before.push_back(body->velocity(vertex));
            tried.push_back(trial->velocity(vertex));
        }
        body->update_prediction(dt);
        for (std::size_t i = 0; i < asked.size(); ++i)
            CHECK(body->velocity(asked[i]) == before[i]);

        for (const auto& [vertex, impulse] : impulses)
            body->apply_impulse(vertex, impulse);
        body->update_prediction(dt);
        // the frames' turn is a mean
        const double exact = kind.find("implicit") == std::string::npos ? 1e-12 : 0.01;
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const Vec3 change = body->velocity(asked[i]) - before[i];
            // nobody pushes vertex 5: only rigid and implicit bodies move it
            REQUIRE((change.norm() > 0.01 || asked[i] == 5));
            CHECK((tried[i] - before[i] - change).norm() < exact * std::max(0.01, change.norm()));
        }
    }
}

TEST_CASE("trials: what is pushed after a velocity was asked counts when it is asked again")
{
    for (const std::string kind : {"rigid", "lumped quadratic", "implicit linear", "implicit quadratic"}) {
        CAPTURE(kind);
        const auto body = body_in_motion(kind, 0.01);
        const Vec3 one(0.5, -1, 2), other(1, 0.3, 0);
        const std::unique_ptr<Trial> in_turn = body->begin_trial(), at_once = body->begin_trial();
        in_turn->push(3, one);
        const Vec3 first = in_turn->velocity(3);
        in_turn->push(3, other);
        at_once->push(3, one);
        at_once->push(3, other);
        const Vec3 both = at_once->velocity(3);
        CHECK((both - first).norm() > 0.1);
        CHECK((in_turn->velocity(3) - both).norm() < 1e-12 * both.norm());
    }
}

TEST_CASE("trials: the inverse mass at a vertex is what a unit impulse tried there changes")
{
    for (const std::string kind : {"rigid", "lumped quadratic", "implicit quadratic"}) {
        CAPTURE(kind);
        const auto body = body_in_motion(kind, 0.01);
        for (const int vertex : {0, 6, 3}) {
            const Mat3 inverse_mass = body->inverse_mass(vertex);
            CHECK((inverse_mass - inverse_mass.transpose()).norm() < 1e-12 * inverse_mass.norm());
            for (int axis = 0; axis < 3; ++axis) {
                const std::unique_ptr<Trial> trial = body->begin_trial();
                trial->push(vertex, Vec3::Unit(axis));
                CHECK((trial->velocity(vertex) - body->velocity(vertex) - inverse_mass.col(axis)).norm() <
                      1e-10 * inverse_mass.norm());
            }
        }
    }
}
