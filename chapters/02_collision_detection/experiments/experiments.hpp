#pragma once

#include "common/experiments/report/chapter_program.hpp"

namespace enduring::chapter02 {

void gallery(const RunOptions& options, Report& report);
void degenerate(const RunOptions& options, Report& report);
void pruning(const RunOptions& options, Report& report);
void cost(const RunOptions& options, Report& report);

/// The queries of a file, answered on stdout, one line each: `0`, or `1` and the time of impact.
struct QueryMode {
    std::string file, kind;  ///< as given by --queries and --kind

    void add_options(CLI::App& app);
    /// @return whether a file was given, and so answered
    /// @throws InputError  the file's first mistake, or a kind other than vf and ee
    bool run() const;
};

}  // namespace enduring::chapter02
