#include "common/experiments/report/progress.hpp"

#include "common/experiments/report/report.hpp"
#include "common/input/input_error.hpp"

#include <sys/ioctl.h>
#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace enduring {
namespace {

using namespace std::chrono_literals;

/// All work that is being done. What stands here is read and changed under the lock, which a work that only
/// counts never takes.
struct Board {
    std::mutex lock;
    std::vector<const Progress*> works;  ///< the outermost first
    std::filesystem::path file;          ///< empty for none
};

Board& board()
{
    static Board all;
    return all;
}

/// As much of a line as fits into one of the terminal.
std::string fitting(std::string line)
{
    winsize size{};
    if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2)
        return line;
    std::size_t length = std::min<std::size_t>(line.size(), size.ws_col - 1U);
    while (length > 0 && length < line.size() && (static_cast<unsigned char>(line[length]) & 0xC0) == 0x80)
        --length;  // not within a letter
    return line.substr(0, length);
}

void write_progress_file(const std::filesystem::path& file)
{
    try {
        write_file(file, "Not finished. " + progress_line() + "\n");
    } catch (const InputError&) {  // a full disk stops what this tells of, and not this
    }
}

/// Looks at the clock while the outermost work lasts.
class Teller {
public:
    Teller() : thread_([this] { tell_until_the_end(); }) {}
    ~Teller()
    {
        {
            const std::lock_guard guard(lock_);
            ended_ = true;
        }
        end_.notify_one();
        thread_.join();
        if (shown_ && terminal_)
            std::fputs("\r\033[K", stderr);
    }
    Teller(const Teller&) = delete;
    Teller& operator=(const Teller&) = delete;

private:
    using Clock = std::chrono::steady_clock;

    void tell_until_the_end()
    {
        const Clock::duration between_lines = terminal_ ? Clock::duration(1s) : Clock::duration(10s);
        Clock::time_point next_line = Clock::now() + between_lines;
        for (std::unique_lock guard(lock_); !end_.wait_for(guard, 1s, [this] { return ended_; });) {
            const std::lock_guard all(board().lock);
            if (!board().file.empty())
                write_progress_file(board().file);
            if (Clock::now() + 100ms < next_line)
                continue;
            next_line += between_lines;
            std::fprintf(stderr, terminal_ ? "\r\033[K%s" : "%s\n",
                         (terminal_ ? fitting(progress_line()) : progress_line()).c_str());
            std::fflush(stderr);
            shown_ = true;
        }
    }

    const bool terminal_ = isatty(STDERR_FILENO) != 0;
    bool ended_ = false, shown_ = false;
    std::mutex lock_;
    std::condition_variable end_;
    std::thread thread_;  // the last, so that the others are there for it
};

std::optional<Teller>& teller()
{
    static std::optional<Teller> of_the_outermost_work;
    return of_the_outermost_work;
}

}  // namespace

Progress::Progress(std::string what, long count, std::string of)
    : what_(std::move(what)), of_(std::move(of)), count_(count)
{
    {
        const std::lock_guard guard(board().lock);
        board().works.push_back(this);
    }
    if (!teller())
        teller().emplace();
}

Progress::~Progress()
{
    {
        const std::lock_guard guard(board().lock);
        std::erase(board().works, this);
        if (!board().works.empty())
            return;
    }
    teller().reset();
}

std::string Progress::text(bool outermost) const
{
    const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    const long done = done_;
    std::string words = what_ + (outermost ? (what_.empty() ? "" : ", ") + rough_duration(seconds) : "");
    const std::string colon = words.empty() ? "" : ": ";
    if (count_ == 0)
        return words + (of_.empty() ? "" : colon + std::to_string(done) + of_);
    words += colon + std::to_string(done) + " of " + std::to_string(count_) + of_;
    if (const double share = share_; share > 0 && share < 1 && seconds >= 1)
        words += ", about " + rough_duration(seconds * (1 - share) / share) + " left";
    return words;
}

std::string progress_line()
{
    std::string line;
    for (const Progress* work : board().works)
        line += (line.empty() ? "" : "; ") + work->text(line.empty());
    return line;
}

std::string rough_duration(double seconds)
{
    if (seconds < 99.5)
        return std::to_string(std::lround(seconds)) + " s";
    const long minutes = std::lround(seconds / 60);
    if (minutes < 100)
        return std::to_string(minutes) + " min";
    return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

ProgressFile::ProgressFile(std::filesystem::path file) : file_(std::move(file))
{
    const std::lock_guard guard(board().lock);
    board().file = file_;
    write_progress_file(file_);
}

ProgressFile::~ProgressFile()
{
    const std::lock_guard guard(board().lock);
    board().file.clear();
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
}

}  // namespace enduring
