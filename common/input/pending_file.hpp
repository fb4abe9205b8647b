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

    /// From now on SIGINT, SIGTERM and SIGHUP first remove every pending neighbour, then end the program as
    /// they always do. Under nohup SIGHUP stays ignored.
    static void cleaned_on_interrupt();

private:
    std::filesystem::path place_, neighbour_;
    bool pending_ = true;
};

/// Writes through a neighbour file and a rename.
/// @throws InputError  the place cannot be written; nothing is left behind
void write_file(const std::filesystem::path& path, const std::string& content);

/// Finds out whether a file could be written, before a run that takes long; what stands there stays.
/// @param asked  whose value the place is, as "--gltf", for the message
/// @throws InputError  it could not
void require_writable(const std::filesystem::path& file, const std::string& asked);
/// The same for files in a folder, which is created.
void require_writable_folder(const std::filesystem::path& folder, const std::string& asked);

}  // namespace enduring
