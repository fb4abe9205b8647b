#pragma once

#include <filesystem>
#include <string>

namespace enduring {

/// A file that grows by whole rows: what is appended reaches it in one piece, or not at all. So a run that is
/// killed, or whose disk is full, leaves no part of a row.
class RowsFile {
public:
    /// Begins the file anew.
    /// @throws InputError  it cannot be written
    explicit RowsFile(std::filesystem::path file);
    ~RowsFile();
    RowsFile(const RowsFile&) = delete;
    RowsFile& operator=(const RowsFile&) = delete;

    /// @throws InputError  no room for all of it: the file is as it was
    void append(const std::string& rows);

private:
    std::filesystem::path file_;
    int descriptor_;
    long length_ = 0;  ///< [bytes]
};

}  // namespace enduring
