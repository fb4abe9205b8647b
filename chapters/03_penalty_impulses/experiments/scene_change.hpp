#pragma once

#include "common/scenes/scene.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace enduring::chapter03 {

/// Method, stiffness [N/m] and step [s] as a change to a scene (see load_scene).
nlohmann::json contact_change(PenaltyMethod method, double stiffness, double dt);

/// The list "bodies" of a scene file, to be changed and given back as a change to the scene.
/// @throws InputError  the file cannot be read
nlohmann::json bodies_of(const std::filesystem::path& file);

}  // namespace enduring::chapter03
