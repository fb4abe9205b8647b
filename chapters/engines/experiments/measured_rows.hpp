#pragma once

#include <map>
#include <string>
#include <vector>

namespace enduring::engines {

using MeasuredRow = std::map<std::string, std::string>;  ///< a cell by its column

/// A table that an earlier run of this program wrote, from chapters/engines/measured; no cell of it has a
/// comma.
/// @throws InputError  it has no rows
std::vector<MeasuredRow> measured_rows(const std::string& name);

}  // namespace enduring::engines
