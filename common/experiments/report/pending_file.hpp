#pragma once

#include <filesystem>
#include <string>

namespace enduring {

/// A file on its way to its place: write to neighbour(), then publish(). Until then a reader of
/// the place meets the old file or none; without publish(), and on Ctrl-C once
/// cleaned_on_interrupt() was called, the neighbour is removed.
///
///     PendingFile file("results/drop.png");
///     draw_to(file.neighbour());
///     file.publish();
class PendingFile {
public:
    /// @param place  where the file belongs; missing folders are created
    /// @throws InputError  a folder on the way cannot be created, or no file in it
    explicit PendingFile(std::filesystem::path place);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// NAME.part in the same folder, so that the rename stays on one file system.
    const std::filesystem::path& neighbour() const { return neighbour_; }
    /// @throws InputError  the rename failed
    void publish();

    /// From now on SIGINT and SIGTERM first remove every pending
    /// neighbour, then end the program as they always do.
    static void cleaned_on_interrupt();

private:
    std::filesystem::path place_, neighbour_;
    bool pending_ = true;
};

}  // namespace enduring
