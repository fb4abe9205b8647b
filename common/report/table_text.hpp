#pragma once

#include "common/report/report.hpp"

#include <string>

namespace enduring {

/// A header row and one line a row; text with commas, quotes or line breaks is quoted (RFC 4180), doubles keep all digits.
std::string csv(const Table& table);

/// A Markdown table under column names in words (column_words.hpp): doubles with `digits` significant digits, columns of
/// numbers set flush right.
std::string markdown(const Table& table, int digits);

}  // namespace enduring
