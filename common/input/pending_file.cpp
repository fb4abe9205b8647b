#include "common/input/pending_file.hpp"

#include "common/input/input_error.hpp"

#include <unistd.h>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <fstream>

namespace enduring {
namespace {

// What a signal handler may read: plain pointers, each alive while its PendingFile is.
std::array<std::atomic<const char*>, 16> pending{};

void remember(const char* name)
{
    for (auto& slot : pending) {
        const char* empty = nullptr;
        if (slot.compare_exchange_strong(empty, name))
            return;
    }
}

void forget(const char* name)
{
    for (auto& slot : pending) {
        const char* mine = name;
        slot.compare_exchange_strong(mine, nullptr);
    }
}

extern "C" void remove_pending_and_end(int signal)
{
    for (auto& slot : pending)
        if (const char* name = slot.load())
            ::unlink(name);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

}  // namespace

PendingFile::PendingFile(std::filesystem::path place) : place_(std::move(place)), neighbour_(place_)
{
    neighbour_ += ".part";
    std::error_code failure;
    if (place_.has_parent_path())
        std::filesystem::create_directories(place_.parent_path(), failure);
    if (!failure && std::filesystem::is_directory(place_))
        failure = std::make_error_code(std::errc::is_a_directory);
    remember(neighbour_.c_str());  // before there is one, or a signal between would leave it
    errno = 0;
    if (!failure && !std::ofstream(neighbour_))
        failure = std::error_code(errno, std::generic_category());
    if (!failure)
        return;
    forget(neighbour_.c_str());
    throw InputError(place_.string() + ": cannot be written (" + failure.message() + ")");
}

PendingFile::~PendingFile()
{
    std::error_code ignored;
    if (pending_)
        std::filesystem::remove(neighbour_, ignored);
    forget(neighbour_.c_str());
}

void PendingFile::publish()
{
    std::error_code failure;
    std::filesystem::rename(neighbour_, place_, failure);
    if (failure)
        throw InputError(place_.string() + ": cannot be written (" + failure.message() + ")");
    pending_ = false;
}

void write_file(const std::filesystem::path& path, const std::string& content)
{
    PendingFile file(path);
    std::ofstream out(file.neighbour(), std::ios::binary);
    out << content;
    out.close();
    if (!out)
        throw InputError(path.string() + ": cannot be written to its end (is the disk full?)");
    file.publish();
}

void require_writable(const std::filesystem::path& file, const std::string& asked)
{
    try {
        const PendingFile trial(file);
    } catch (const InputError& failure) {
        throw InputError(asked + ": " + failure.what());
    }
}

void require_writable_folder(const std::filesystem::path& folder, const std::string& asked)
{
    if (std::error_code ignored;
        std::filesystem::exists(folder, ignored) && !std::filesystem::is_directory(folder, ignored))
        throw InputError(asked + ": " + folder.string() + " is a file, and a folder is needed");
    try {
        const PendingFile trial(folder / "writable");
    } catch (const InputError& failure) {
        throw InputError(asked + ": " + failure.what());
    }
}

void PendingFile::cleaned_on_interrupt()
{
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, remove_pending_and_end);
    if (std::signal(SIGHUP, remove_pending_and_end) == SIG_IGN)
        std::signal(SIGHUP, SIG_IGN);  // under nohup
}

}  // namespace enduring
