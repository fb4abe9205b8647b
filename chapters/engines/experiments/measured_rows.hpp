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

/// A number of such a table; "inf" is what was lost.
double measured_number(const std::string& text);
/// A name for a fact: letters, digits and underscores.
std::string fact_word(std::string title);

}  // namespace enduring::engines
