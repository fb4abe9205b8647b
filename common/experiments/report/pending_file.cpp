#include "common/experiments/report/pending_file.hpp"

#include "common/input/input_error.hpp"

#include <unistd.h>
#include <array>
#include <atomic>
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
    if (failure || !std::ofstream(neighbour_))
        throw InputError(place_.string() + ": cannot be written" +
                         (failure ? " (" + failure.message() + ")" : ""));
    remember(neighbour_.c_str());
}

PendingFile::~PendingFile()
{
    forget(neighbour_.c_str());
    std::error_code ignored;
    if (pending_)
        std::filesystem::remove(neighbour_, ignored);
}

void PendingFile::publish()
{
    std::error_code failure;
    std::filesystem::rename(neighbour_, place_, failure);
    if (failure)
        throw InputError(place_.string() + ": cannot be written (" + failure.message() + ")");
    pending_ = false;
}

void PendingFile::cleaned_on_interrupt()
{
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, remove_pending_and_end);
}

}  // namespace enduring
