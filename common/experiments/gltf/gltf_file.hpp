#pragma once

#include "common/experiments/gltf/animation.hpp"

namespace enduring {

/// @throws InputError  the program was built without TinyGLTF
void require_gltf();

/// @param file  ends with .glb; its folder is made if it is missing
/// @throws InputError  it cannot be written
void write_gltf(const std::filesystem::path& file, const std::vector<GltfAnimation::Track>& tracks,
                const std::vector<Plane>& planes);

}  // namespace enduring
