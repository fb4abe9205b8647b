#pragma once

#include "common/scenes/scene.hpp"
#include "common/simulation/contact.hpp"
#include "common/simulation/step_work.hpp"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

/// What the book's laboratory is told of a scene and of its steps: by the layers in the page
/// (live/lab/bindings.cpp), and by the file of a run (common/experiments/own_scene/replay.hpp).
namespace enduring {

/// Of one step.
struct StepNumbers {
    double time = 0;                                                  ///< [s]
    int step = 0;                                                     ///< committed so far
    double kinetic = 0, gravitational = 0, elastic = 0, springs = 0;  ///< [J]
    double depth = 0;                                                 ///< of the deepest pair [m]
    int pairs = 0;                                                    ///< that push
    long thrown_away = 0;  ///< attempts so far that were taken again in halves
    long ended_badly = 0;  ///< parts of steps so far that could not be halved any more
    StepWork work{};       ///< of the last step
};

StepNumbers step_numbers(const World& world, const Contacts& contacts);
/// Each number by its name.
nlohmann::json shown_numbers(const StepNumbers& numbers);

/// A pair as numbers: kind, bodies A and B, features of A and B, point of A [m], normal out of B, depth [m],
/// impulse and friction impulse on A in the last step [N s], stiffness, rest offset, load, slip, whether it
/// may push, and the step in which its features met. live/lab/pairs.js gives them their names again.
using PairNumbers = std::array<double, 24>;

/// Joints as numbers, nine each: its point on A and on B [m], and the axis of a hinge, slider or cylinder,
/// zero for others. A gear has no place and a broken joint holds nothing: they have no numbers.
std::vector<double> joint_numbers(const World& world);

/// @param since  the step in which these features met; -1 where nobody knows
PairNumbers pair_numbers(const World& world, const Contact& contact, int since = -1);

/// A body that never moves: a run's file has its place only once.
bool rests(const Body& body);

/// What is drawn: bodies with their faces, planes and camera; warnings; and the solver's name.
nlohmann::json shown_scene(const Scene& scene, const World& world, const std::string& solver);

/// In one line; what is no UTF-8 in a name is replaced.
std::string line_of(const nlohmann::json& shown);

}  // namespace enduring
