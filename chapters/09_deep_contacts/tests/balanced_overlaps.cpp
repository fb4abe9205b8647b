#include "chapters/09_deep_contacts/tests/quiet_solver.hpp"
#include "common/scenes/scene_reader.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

namespace {

/// A cube of 10 cm that begins 3 mm inside each of two walls beside it, and falls out below them.
Scene cube_between_walls(double dt)
{
    return read_scene(R"({"name": "s", "dt": )" + std::to_string(dt) + R"(, "duration": 0.6, "bodies": [
        {"name": "cube", "type": "rigid", "shape": {"box": {"size": [0.1, 0.1, 0.1]}}, "density": 1000, "position": [0, 1, 0]},
        {"name": "left", "type": "static", "shape": {"box": {"size": [0.1, 0.3, 0.3]}}, "position": [-0.097, 0.95, 0]},
        {"name": "right", "type": "static", "shape": {"box": {"size": [0.1, 0.3, 0.3]}}, "position": [0.097, 0.95, 0]}]})",
                      "", "s.json", {});
}

}  // namespace

TEST_CASE("depenetration: springs whose pushes cancel are not wound up, though their impulses move nothing")
{
    for (const double dt : {0.005, 0.01, 0.02}) {
        CAPTURE(dt);
        Scene scene = cube_between_walls(dt);
        const Solver solver = chapter09::quiet_solver(scene.contact);
        Contacts contacts;
        while (scene.world.time < scene.duration - dt / 2)
            advance(scene.world, contacts, solver, dt);
        CHECK(scene.world.ended_badly == 0);
        CHECK(scene.world.bodies[0]->mean_velocity().y() == doctest::Approx(-9.81 * 0.6).epsilon(1e-3));
    }
}

TEST_CASE("depenetration: a stone that a plate passes right through is not thrown, whatever the plate's mesh")
{
    for (const char* cells : {"[2, 1, 2]", "[2, 1, 8]", "[2, 1, 20]", "[20, 1, 2]"}) {
        CAPTURE(cells);
        Scene scene = read_scene(R"({"name": "s", "dt": 0.01, "duration": 0.2, "bodies": [
            {"name": "plate", "type": "static", "shape": {"slope": {"size": [2, 0.1, 2], "angle_deg": 10, "cells": )" +
                                     std::string(cells) + R"(}}},
            {"name": "stone", "type": "rigid", "mass": 2, "shape": {"tetrahedron": {"edge": 1}}}]})",
                                 "", "s.json", {});
        const Solver solver = chapter09::quiet_solver(scene.contact);
        const Body& stone = *scene.world.bodies[1];
        const double first = stone.energy(scene.world.gravity).total();
        Contacts contacts;
        double gained = 0;
        while (scene.world.time < scene.duration - scene.dt / 2) {
            advance(scene.world, contacts, solver, scene.dt);
            gained = std::max(gained, stone.energy(scene.world.gravity).total() - first);
        }
        CHECK(gained < 0.1);  // at the speed of letting out it would have 0.05 J
        CHECK(scene.world.ended_badly == 0);
    }
}
