#pragma once

#include "common/scenes/scene.hpp"

#include <random>
#include <string>
#include <vector>

namespace enduring::chapter09 {

/// What is shot at: a plate, or a bowl for a shell.
struct ThinTarget {
    std::string name, body;  ///< of the scene file
    bool shell = false;
};
const std::vector<ThinTarget>& thin_targets();

/// The names of the bodies that are shot: a ball, a cube, a plate of 1 % of its size.
const std::vector<std::string>& thin_shots();

/// A shot at a thin target, from one of its two sides.
struct ThinShot {
    const ThinTarget* target;
    std::string body;
    double side;     ///< 1 above the plate or in the hollow of the shell, -1 on the other side
    double speed;    ///< [m/s]
    int upper_face;  ///< of a plate
    Scene scene;     ///< of as many steps as it takes to arrive, and 20 more
};

/// Any direction within 60 degrees of straight, any place, any turn and spin, at 1 to 40 m/s with one of
/// three steps.
ThinShot shot_at_random(const ThinTarget& target, const std::string& body, std::mt19937_64& random);

/// Whether the shot's middle is on the other side, behind the target and not beside it.
bool is_through(const ThinShot& shot, const World& world);

}  // namespace enduring::chapter09
