#include "common/experiments/report/table.hpp"

#include "common/experiments/report/column_words.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>
#include <stdexcept>

namespace enduring {
namespace {

std::string csv_text(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

std::string markdown_text(const std::string& text)
{
    std::string escaped;
    for (const char c : text)
        escaped += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
    return escaped;
}

std::string csv_cell(const Cell& cell)
{
    if (const auto* text = std::get_if<std::string>(&cell))
        return csv_text(*text);
    if (const auto* whole = std::get_if<long>(&cell))
        return std::to_string(*whole);
    return shortest(std::get<double>(cell));
}

std::string markdown_cell(const Cell& cell, int digits)
{
    if (const auto* text = std::get_if<std::string>(&cell))
        return markdown_text(*text);
    if (const auto* whole = std::get_if<long>(&cell))
        return std::to_string(*whole);
    return readable(std::get<double>(cell), digits);
}

bool holds_numbers(const Table& table, std::size_t column)
{
    return !table.rows().empty() &&
           std::none_of(table.rows().begin(), table.rows().end(),
                        [&](const auto& row) { return std::holds_alternative<std::string>(row[column]); });
}

}  // namespace

Table::Table(std::vector<std::string> columns) : columns_(std::move(columns)) {}

void Table::add(std::vector<Cell> row)
{
    if (row.size() != columns_.size())
        throw std::logic_error("a row of " + std::to_string(row.size()) + " cells for a table of " +
                               std::to_string(columns_.size()) + " columns");
    rows_.push_back(std::move(row));
}

void Table::append(const Table& other)
{
    if (other.columns_ != columns_)
        throw std::logic_error("rows of a table with other columns");
    rows_.insert(rows_.end(), other.rows_.begin(), other.rows_.end());
}

std::string csv(const Table& table) { return csv_head(table) + csv_rows(table); }

std::string csv_head(const Table& table)
{
    std::string text;
    for (std::size_t c = 0; c < table.columns().size(); ++c) {
        text += csv_text(table.columns()[c]);
        text += c + 1 < table.columns().size() ? ',' : '\n';
    }
    return text;
}

std::string csv_rows(const Table& table, std::size_t from)
{
    std::string text;
    for (std::size_t r = from; r < table.rows().size(); ++r) {
        const std::vector<Cell>& row = table.rows()[r];
        for (std::size_t c = 0; c < row.size(); ++c) {
            text += csv_cell(row[c]);
            text += c + 1 < row.size() ? ',' : '\n';
        }
    }
    return text;
}

std::string markdown(const Table& table, int digits)
{
    std::string head = "|", rule = "|", body;
    for (std::size_t c = 0; c < table.columns().size(); ++c) {
        head += ' ' + markdown_text(column_words(table.columns()[c])) + " |";
        rule += holds_numbers(table, c) ? "---:|" : "---|";
    }
    for (const auto& row : table.rows()) {
        body += '|';
        for (const Cell& cell : row)
            body += ' ' + markdown_cell(cell, digits) + " |";
        body += '\n';
    }
    return head + '\n' + rule + '\n' + body;
}

}  // namespace enduring
