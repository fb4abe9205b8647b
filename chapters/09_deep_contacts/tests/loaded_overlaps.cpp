#include "chapters/09_deep_contacts/solver.hpp"
#include "common/scenes/scene.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

namespace {

const char* const lever_text = R"({
  "name": "lever", "dt": 0.002, "duration": 0.3,
  "bodies": [
    {"name": "floor", "type": "static", "shape": {"box": {"size": [2, 0.5, 2]}}, "position": [0, -0.25, 0]},
    {"name": "box", "type": "rigid", "shape": {"box": {"size": [0.2, 0.2, 0.2]}}, "mass": 0.1, "position": [0.4, 0.09, 0],
     "locked": {"translation": ["x", "z"], "rotation": ["x", "y", "z"]}},
    {"name": "lever", "type": "rigid", "shape": {"box": {"size": [1, 0.1, 0.1]}}, "mass": 1, "position": [0, 0.24, 0],
     "locked": {"translation": ["x", "y", "z"], "rotation": ["x", "y"]}, "forces": [{"torque": [0, 0, -400]}]}
  ]})";

const char* const block_text = R"({
  "name": "block", "dt": 0.01, "duration": 1,
  "bodies": [
    {"name": "floor", "type": "static", "shape": {"box": {"size": [2, 0.5, 2]}}, "position": [0, -0.25, 0]},
    {"name": "block", "type": "deformable", "shape": {"bar": {"size": [0.2, 0.2, 0.2], "cells": [2, 2, 2]}},
     "basis": "linear", "mass": 0.1, "young": 1e6, "poisson": 0.3, "position": [0, 0.09, 0],
     "fixed": {"min": [-1, 0.09, -1]}}
  ]})";

/// Runs a scene to its end.
/// @return  the deepest pair then, over the size of the smaller bodies, 0.2 m
double depth_at_end(const char* text)
{
    Scene scene = read_scene(text, "", "loaded.json", {});
    const Solver solver = chapter09_solver(scene.contact);
    Contacts contacts;
    while (scene.world.time < scene.duration - 0.5 * scene.dt)
        advance(scene.world, contacts, solver, scene.dt);
    double deepest = 0;
    for (const Contact& contact : contacts)
        if (contact.spring.load > 0)
            deepest = std::min(deepest, contact_geometry(scene.world, contact, 1).depth);
    return -deepest / 0.2;
}

}  // namespace

// 10 mm of a box of 0.2 m are 0.05 of its size.
TEST_CASE("depenetration: a light box comes out of a floor though a torque presses with 600 times its weight")
{
    CHECK(depth_at_end(lever_text) < 2 * scale_parts.wanted_depth);
}

TEST_CASE(
    "depenetration: a light soft block that is held above comes out of a floor against its own elements")
{
    CHECK(depth_at_end(block_text) < 2 * scale_parts.wanted_depth);
}
