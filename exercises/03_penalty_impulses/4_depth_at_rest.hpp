#pragma once

#include "common/scenes/scene_reader.hpp"

#include <string>

namespace enduring {

/// A rigid cube of 50 cm that comes to rest on a floor. The floor is one large triangle under all of the
/// cube; the cube's sides are cut into cells x cells squares, of two triangles each.
struct RestingCube {
    int cells = 1;            ///< along each side of the cube
    double mass = 20;         ///< [kg]
    double stiffness = 2000;  ///< k of one pair [N/m]
    double dt = 0.01;         ///< [s]
    PenaltyMethod method = PenaltyMethod::continuous;
};

constexpr double cube_gravity = 9.81;  ///< [m/s^2]

/// The scene: the floor is y = 0, bodies[0]; the cube, bodies[1], starts a
/// tenth of a millimetre above it. It lasts 10 s.
inline Scene cube_on_floor(const RestingCube& cube)
{
    const auto text = [](double value) { return std::to_string(value); };
    const std::string cells = std::to_string(cube.cells),
                      method = cube.method == PenaltyMethod::continuous ? "cpf" : "dpf";
    return read_scene(R"({"name": "cube_on_floor", "duration": 10, "dt": )" + text(cube.dt) +
                          R"(, "contact": {"method": ")" + method + R"(", "stiffness": )" +
                          text(cube.stiffness) + R"(}, "bodies": [{"name": "floor", "type": "static",
                          "shape": {"plane_grid": {"size": [8, 8], "cells": [1, 1]}}, "position": [2, 0, -2]}, {"name": "cube", "type": "rigid",
                          "shape": {"box": {"size": [0.5, 0.5, 0.5], "cells": [)" +
                          cells + "," + cells + "," + cells + R"(]}}, "mass": )" + text(cube.mass) +
                          R"(, "position": [0, 0.2501, 0]}]})",
                      "", "cube_on_floor", {});
}

/// Your prediction, written down before anything is measured: how many times less deep a cube of 4 cells a
/// side lies than one of 1 cell a side, everything else being the same.
double predicted_factor();

/// Runs the scene for as long as it lasts and returns how far the cube's lowest vertex then lies under the
/// floor [m], as a positive length.
double depth_at_rest(const RestingCube& cube);

/// The factor that was predicted, measured: depth with the cube's
/// cells over depth with this many cells a side.
double measured_factor(RestingCube cube, int other_cells);

/// The law: the depth at rest [m] from mass, gravity, stiffness, number of pairs, step and method.
double law_of_depth(const RestingCube& cube);

}  // namespace enduring
