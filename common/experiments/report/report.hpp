#pragma once

#include "common/experiments/report/rows_file.hpp"
#include "common/experiments/report/table.hpp"
#include "common/input/pending_file.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace enduring {

/// Where an experiment leaves what it measured. Every file is written beside its place and then renamed, so a
/// reader never meets half a file. A run that is stopped leaves of its tables what rows_so_far() was given,
/// under names that say so.
class Report {
public:
    /// @param folder  created if missing, e.g. build/results/01_particle_plane
    /// @throws InputError  it cannot be created or written
    explicit Report(std::filesystem::path folder);
    /// Takes a folder away again that it made and nobody wrote into, as after a scene with a mistake; and
    /// growing tables without a row.
    ~Report();
    Report(const Report&) = delete;
    Report& operator=(const Report&) = delete;

    /// NAME.csv with all digits (shortest form that reads back the same double).
    void table(const std::string& name, const Table& table);
    /// A table that grows, as NAME.unfinished.csv: rows that are new since the last call reach the file
    /// before this returns. table() with the same name ends it.
    /// @param table  the one of the last call, with more rows
    void rows_so_far(const std::string& name, const Table& table);
    /// NAME.md for the book's page: names of columns in words (dt_s: "Δt
    /// [s]"), numbers with `digits` significant digits.
    void page_table(const std::string& name, const Table& table, int digits = 3);
    /// One named number of the text, as `@fact{experiment.name}`: facts_EXPERIMENT.csv, one row
    /// a fact with the columns name,value,text. The text is the number with `digits`
    /// significant digits; telling a fact again replaces it.
    void fact(const std::string& experiment, const std::string& name, double value, int digits = 3);
    /// A fact without a number: its value is empty.
    void fact(const std::string& experiment, const std::string& name, const std::string& text);
    /// Runs a gnuplot script that writes NAME.svg. The script reads the tables in `folder` and begins with
    /// `load style` (plot_style.gp: the common look, and the picture's place from `output`). Without gnuplot
    /// there is no plot, not an old one either, and stderr says so once.
    /// @param script  seen from the root of the sources, e.g. "chapters/04_friction/plots/slope.gp"
    /// @param name    of the picture; as the script when empty
    /// @throws InputError          there is no such script
    /// @throws std::runtime_error  gnuplot failed, or drew nothing
    void plot(const std::filesystem::path& script, const std::string& name = "");
    /// Where a file that somebody else writes belongs:
    /// file("ground.png"). It counts as written by this report.
    std::filesystem::path file(const std::string& name);
    const std::filesystem::path& folder() const { return folder_; }
    /// Files written through this report, in order and each once.
    const std::vector<std::filesystem::path>& written() const { return written_; }

private:
    /// A table of which some rows stand in a file.
    struct Growing {
        std::unique_ptr<RowsFile> file;
        std::size_t rows = 0;
    };
    void write_facts(const std::string& experiment, std::vector<Cell> fact);
    std::filesystem::path unfinished(const std::string& table) const;

    std::filesystem::path folder_;
    bool made_folder_ = false;
    std::map<std::string, Growing> growing_;  ///< by name
    /// by experiment, in the order they were told
    std::map<std::string, std::vector<std::vector<Cell>>> facts_;
    std::vector<std::filesystem::path> written_;
};

}  // namespace enduring
