#pragma once

#include "common/scenes/scene.hpp"

namespace enduring {

/// What a scene says without a mistake and what will go wrong all the same: bodies that overlap at the start,
/// with others or with themselves, that lie flat under their weight, or whose elements lock. Readers of
/// scenes put it into Scene::warnings.
/// @param file  named in front of each
std::vector<std::string> scene_warnings(const Scene& scene, const std::string& file);

/// The same for a solver that takes the scene's stiffness, or the default: one that the step cannot bear.
std::optional<std::string> stiffness_warning(const Scene& scene, const std::string& file);

}  // namespace enduring
