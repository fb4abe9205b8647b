#pragma once

#include <filesystem>
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
    const std::vector<std::string>& columns() const { return columns_; }
    const std::vector<std::vector<Cell>>& rows() const { return rows_; }

private:
    std::vector<std::string> columns_;
    std::vector<std::vector<Cell>> rows_;
};

/// Where an experiment leaves what it measured. Every file is written beside its place and then renamed, so a
/// reader never meets half a file, and a run that is interrupted leaves none.
class Report {
public:
    /// @param folder  created if missing, e.g. build/results/01_particle_plane
    /// @throws InputError  it cannot be created or written
    explicit Report(std::filesystem::path folder);

    /// NAME.csv with all digits (shortest form that reads back the same double).
    void table(const std::string& name, const Table& table);
    /// NAME.md for the book's page, numbers with `digits` significant digits.
    void page_table(const std::string& name, const Table& table, int digits = 3);
    /// One named number of the text, as `@fact{experiment.name}`: facts_EXPERIMENT.csv, one row a fact (name,value,text).
    void fact(const std::string& experiment, const std::string& name, double value, int digits = 3);
    void fact(const std::string& experiment, const std::string& name, const std::string& text);
    /// Runs a gnuplot script on the tables of this folder; the script reads `folder` and writes NAME.svg.
    void plot(const std::filesystem::path& script, const std::string& name);
    /// Where a picture called NAME.png belongs.
    std::filesystem::path file(const std::string& name) const;
    const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
};

/// Writes through a neighbour file and a rename.
/// @throws InputError  the place cannot be written; nothing is left behind
void write_file(const std::filesystem::path& path, const std::string& content);

}  // namespace enduring
