#pragma once

#include <filesystem>

namespace enduring {

/// The root of the project's sources, as it was when this program was built:
/// scenes, meshes and reference pictures lie there.
std::filesystem::path source_directory();

}  // namespace enduring
