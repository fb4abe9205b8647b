#pragma once

#include <filesystem>
#include <fstream>

namespace enduring {

/// Opens what a reader is given. Pipes and devices are refused, since nothing says that they end: a reader of
/// /dev/zero would read for ever.
/// @throws InputError  no such file; a folder, a pipe or a device; one that may not be read
std::ifstream open_file(const std::filesystem::path& file);

}  // namespace enduring
