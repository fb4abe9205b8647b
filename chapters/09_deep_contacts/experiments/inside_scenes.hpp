#pragma once

#include "common/scenes/scene.hpp"

#include <string>
#include <vector>

namespace enduring::chapter09 {

/// What a body begins inside, and the bodies that do. The surface is at height 0, at least under the body.
struct Surroundings {
    std::string name;
    std::string planes, bodies;  ///< of the scene file; each body is followed by a comma
    std::vector<std::string> inner;
};

/// A floor of 1 m, a plane, a bowl and a cushion that is soft.
const std::vector<Surroundings>& all_surroundings();

/// A body of 20 kg whose lowest vertex begins so deep inside [m]; of negative depth above.
/// @param body  "block", "leaning block", "fine block", "block on a corner", "plate", "ball" or "soft block"
Scene scene_inside(const Surroundings& surroundings, const std::string& body, double depth, double dt);

/// The scene of chapter 6's film with the bunny pushed into the wall of the bowl; nothing moves yet.
Scene bunny_in_wall();

/// How tall the body is as it stands at first [m]: deeper than that it is wholly inside.
double height_of(const Surroundings& surroundings, const std::string& body);

/// The lowest vertex of the body that begins inside [m].
double lowest_vertex(const World& world);

/// How deep the deepest vertex of the body is still inside [m], 0 if none is.
double deepest_inside(const World& world);

}  // namespace enduring::chapter09
