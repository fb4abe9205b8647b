#include "chapters/solvers/chapter_solver.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/step.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

// What the format says of the solvers from chapter 7 on: all of them bounce, and all of them know sheets.

using namespace enduring;

namespace {

constexpr int first_chapter = 7;

Scene scene_of(const std::string& entries, double dt)
{
    return read_scene(R"({"name": "s", "dt": )" + std::to_string(dt) + R"(, "duration": 9, )" + entries + "}",
                      "", "s.json", {});
}

/// Steps until `watch` has seen enough, or for some seconds.
void run_under(int chapter, Scene& scene, double seconds, const std::function<bool(const World&)>& watch)
{
    const Solver solver = solvers::chapter_solver(chapter, scene.contact);
    Contacts contacts;
    while (scene.world.time < seconds) {
        advance(scene.world, contacts, solver, scene.dt);
        if (watch(scene.world))
            return;
    }
}

/// A ball falls half a metre: the part of the height that its first bounce keeps.
double kept_height(int chapter, double e, const std::string& floor, double dt)
{
    Scene scene = scene_of(
        R"("contact": {"restitution": )" + std::to_string(e) + R"(}, )" + floor +
            R"({"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.1}}, "mass": 1,
                                   "position": [0.13, 0.6, 0.06]}])",
        dt);
    const Body& ball = *scene.world.bodies.back();
    double highest = 0, last = ball.centre().y();
    bool rises = false;
    run_under(chapter, scene, 1, [&](const World&) {
        const double now = ball.centre().y();
        const bool over = rises && now < last;
        rises = now > last;
        last = now;
        highest = rises ? now - 0.1 : highest;
        return over;
    });
    return highest / 0.5;
}

const std::string plane = R"("planes": [{"name": "ground"}], "bodies": [)",
                  triangles = R"("bodies": [{"name": "floor", "type": "static",
    "shape": {"plane_grid": {"size": [4, 4], "cells": [4, 4]}}}, )";

/// Velocities of five balls in a line after the first one has come with 1 m/s.
std::vector<double> cradle(int chapter, double gap, double dt)
{
    std::string bodies;
    for (int i = 0; i < 5; ++i)
        bodies +=
            (i > 0 ? ", " : "") + std::string(R"({"name": "ball )") + std::to_string(i) +
            R"(", "type": "rigid", "shape": {"box": {"size": [0.1, 0.1, 0.1]}}, "mass": 1, "position": [)" +
            std::to_string(i * (0.1 + gap) - (i == 0 ? 0.213 : 0)) + R"(, 0, 0], "velocity": [)" +
            (i == 0 ? "1" : "0") +
            R"(, 0, 0], "locked": {"translation": ["y", "z"], "rotation": ["x", "y", "z"]}})";
    Scene scene = scene_of(
        R"("gravity": [0, 0, 0], "contact": {"restitution": 1}, "bodies": [)" + bodies + "]", dt);
    run_under(chapter, scene, 0.6, [](const World&) { return false; });
    std::vector<double> end;
    end.reserve(scene.world.bodies.size());
    for (const auto& body : scene.world.bodies)
        end.push_back(body->mean_velocity().x());
    return end;
}

/// How high a box is after a second over the border of a sheet, by how far its centre is beyond.
double height_on_sheet(int chapter, double beyond, double dt)
{
    Scene scene = scene_of(
        R"("contact": {"friction": {"model": "mass_splitting"}}, "bodies": [
        {"name": "sheet", "type": "static", "sheet": true, "shape": {"plane_grid": {"size": [1, 1]}}},
        {"name": "box", "type": "rigid", "shape": {"box": {"size": [0.3, 0.2, 0.25]}}, "mass": 2, "position": [)" +
            std::to_string(0.5 + beyond) + R"(, 0.1, 0.05]}])",
        dt);
    run_under(chapter, scene, 1, [](const World&) { return false; });
    return scene.world.bodies[1]->centre().y();
}

}  // namespace

TEST_CASE("from chapter 7 on: the first bounce of a ball keeps e^2 of its height, within 2 percent")
{
    for (int chapter = first_chapter; chapter <= solvers::chapters; ++chapter)
        for (const double dt : {0.01, 0.005, 0.002})
            for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0})
                for (const std::string& floor : {plane, triangles}) {
                    if (dt < 0.005 && floor == triangles && chapter > first_chapter)
                        continue;
                    CAPTURE(chapter);
                    CAPTURE(dt);
                    CAPTURE(e);
                    CAPTURE((floor == plane));
                    CHECK(std::abs(kept_height(chapter, e, floor, dt) - e * e) < 0.02 * e * e + 1e-3);
                }
}

TEST_CASE("from chapter 7 on: five bodies in a line hand their momentum on")
{
    for (int chapter = first_chapter; chapter <= solvers::chapters; ++chapter)
        for (const double gap : {1e-2, 1e-3}) {
            const std::vector<double> end = cradle(chapter, gap, 0.01);
            CAPTURE(chapter);
            CAPTURE(gap);
            for (std::size_t ball = 0; ball < end.size(); ++ball)
                CHECK(std::abs(end[ball] - (ball == 4 ? 1 : 0)) < 0.02);
        }
}

TEST_CASE(
    "from chapter 7 on: a box over the border of a sheet stays if its middle is over the sheet, and falls if not")
{
    for (int chapter = first_chapter; chapter <= solvers::chapters; ++chapter)
        for (const double dt : {0.01, 0.004}) {
            CAPTURE(chapter);
            CAPTURE(dt);
            CHECK(std::abs(height_on_sheet(chapter, -0.05, dt) - 0.1) < 1e-3);
            CHECK(height_on_sheet(chapter, 0.05, dt) < -0.5);
        }
}
