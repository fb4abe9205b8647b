#pragma once

#include "common/scenes/material_reader.hpp"
#include "common/scenes/shape_reader.hpp"
#include "common/simulation/body.hpp"

#include <memory>

namespace enduring {

/// Builds one entry of a scene's "bodies": shape, placement, material, motion and forces.
/// @throws InputError  anything the format does not allow, with the JSON path
std::unique_ptr<Body> read_body(const JsonValue& value, const SceneSurroundings& surroundings,
                                const SceneMaterials& materials);

}  // namespace enduring
