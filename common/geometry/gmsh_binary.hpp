#pragma once

#include <string>

namespace enduring {

/// Whether the bytes of a Gmsh file say that numbers follow as they stand in memory.
bool is_binary_gmsh(const std::string& bytes);

/// A binary Gmsh file, version 2.2 or 4.1, as the text file that holds the same: format, groups, nodes and
/// elements, every number with all of its digits. Other sections are left out. What the numbers mean is not
/// looked at, that is for the reader of text.
///
/// @throws InputError  "file, byte N: reason": another version, sizes of numbers other than 4 and 8 bytes, an
///                     element whose type has no known number of nodes, or a file that ends too early
std::string gmsh_as_text(const std::string& bytes, const std::string& name);

}  // namespace enduring
