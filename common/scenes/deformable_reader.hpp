#pragma once

#include "common/scenes/material_reader.hpp"
#include "common/scenes/shape_reader.hpp"
#include "common/simulation/body.hpp"

#include <memory>

namespace enduring {

/// Builds an entry of a scene's "bodies" whose type is "deformable".
/// @throws InputError  anything the format does not allow, with the JSON path
std::unique_ptr<Body> read_deformable(const JsonValue& value, const SceneSurroundings& surroundings,
                                      const SceneMaterials& materials);

}  // namespace enduring
