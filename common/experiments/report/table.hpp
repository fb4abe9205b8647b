#pragma once

#include <string>
#include <variant>
#include <vector>

namespace enduring {

/// One cell of a table: text, a whole number, or a measured number.
using Cell = std::variant<std::string, long, double>;

/// Rows under named columns; the units stand in the names, as in "dt_s" or "depth_m".
class Table {
public:
    explicit Table(std::vector<std::string> columns);
    /// @throws std::logic_error  as many cells as columns are needed
    void add(std::vector<Cell> row);
    /// All rows of another table with the same columns.
    /// @throws std::logic_error  it has other columns
    void append(const Table& other);
    const std::vector<std::string>& columns() const { return columns_; }
    const std::vector<std::vector<Cell>>& rows() const { return rows_; }

private:
    std::vector<std::string> columns_;
    std::vector<std::vector<Cell>> rows_;
};

/// A header row and one line a row; text with commas, quotes or line breaks
/// is quoted (RFC 4180), doubles keep all digits.
std::string csv(const Table& table);
/// Its header row alone, and its rows from one on: together they are all of it.
std::string csv_head(const Table& table);
std::string csv_rows(const Table& table, std::size_t from = 0);

/// A Markdown table under column names in words (column_words.hpp): doubles with `digits` significant digits,
/// columns of numbers set flush right.
std::string markdown(const Table& table, int digits);

}  // namespace enduring
