#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace enduring {

/// Reads a document; complains with line and column of a syntax error and
/// about a key that stands twice in one object.
/// @throws InputError
nlohmann::json parse_json(const std::string& text, const std::string& file);

/// The contents of a file.
/// @throws InputError  it does not exist or cannot be read
std::string read_text_file(const std::filesystem::path& path);

/// Changes a document by a JSON merge patch (RFC 7386): objects merge, null removes, all else replaces.
///
/// A key that begins with '/' leads into the document, so that a patch can reach one
/// entry of a list: {"/bodies/bunny/young": 1e5} or {"/bodies/0": {"young": 1e5}}.
/// In a list a step is an index or the entry's "name".
/// @param file  the document's, named in messages
/// @throws InputError  a path that leads nowhere
void apply_patch(nlohmann::json& document, const nlohmann::json& patch, const std::string& file);

}  // namespace enduring
