#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>

namespace enduring {

/// Long work that says how far it has come: on stderr, and in a ProgressFile while there is one. Work inside
/// of other work is told behind it:
///
///     creep, 5 min: 37 of 340 rows, about 40 min left; scene, chapter 7: 310 of 800
///
/// A terminal shows one line that renews itself, from the second second on. Elsewhere there is a line every
/// ten seconds, however long the work is silent: a thread of its own looks at the clock.
class Progress {
public:
    /// @param count  how much there is to do; 0 if nobody knows
    /// @param of     what is counted, as " rows"; left out if empty
    explicit Progress(std::string what, long count = 0, std::string of = "");
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(long done) { update(done, static_cast<double>(done) / static_cast<double>(count_)); }
    /// @param share  of the work that is done, 0 to 1, where not all parts take alike
    void update(long done, double share)
    {
        done_ = done;
        share_ = share;
    }

private:
    using Clock = std::chrono::steady_clock;
    friend std::string progress_line();
    std::string text(bool outermost) const;

    const std::string what_, of_;
    const long count_;
    const Clock::time_point begin_ = Clock::now();
    std::atomic<long> done_ = 0;
    std::atomic<double> share_ = 0;  ///< NaN where nobody knows how much there is to do
};

/// What a reader is told now; empty if no work is being done.
std::string progress_line();

/// "42 s", "5 min", "1 h 20 min": as rough as an estimate is.
std::string rough_duration(double seconds);

/// A file that says how far the work has come, at first and then each second, as long as this lives. A run
/// that is killed leaves it. One at a time.
class ProgressFile {
public:
    explicit ProgressFile(std::filesystem::path file);
    ~ProgressFile();  ///< removes the file
    ProgressFile(const ProgressFile&) = delete;
    ProgressFile& operator=(const ProgressFile&) = delete;

private:
    std::filesystem::path file_;
};

}  // namespace enduring
