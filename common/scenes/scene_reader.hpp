#pragma once

#include "common/scenes/scene.hpp"
#include "common/scenes/shape_reader.hpp"

#include <string>

namespace enduring {

/// Builds a scene from the text of a scene file; load_scene() reads
/// the file and says where meshes are searched.
/// @param text   JSON as the scene format describes it
/// @param patch  changes to it (see apply_patch), empty for none
/// @param file   named in messages
/// @throws InputError  any mistake in either, with its JSON path
Scene read_scene(const std::string& text, const std::string& patch, const std::string& file,
                 const SceneSurroundings& surroundings);

}  // namespace enduring
