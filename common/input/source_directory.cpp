#include "common/input/source_directory.hpp"

namespace enduring {

// The only file that is compiled with the path: every other object is the same wherever the sources lie.
std::filesystem::path source_directory() { return ENDURING_SOURCE_DIR; }

}  // namespace enduring
